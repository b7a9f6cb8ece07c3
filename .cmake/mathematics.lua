-- A filter for pandoc, run in the folder ref, that joins README.md and the pages that it links to into one page. Links
-- between them become links within this page; the names of sources and tests stay as text.

local style = [[
<style>
body { max-width: 60rem; padding: 1rem; }
p, .scroll { overflow: auto hidden; padding: .4em 0; margin: .6em 0; }
.scroll table { min-width: 45rem; }
#TOC > ul { columns: 20rem; }
</style>]]

local pages = {''}  -- folders, in the order of their first links

-- The place in this page, or outside it, to which a link of the page in FOLDER leads; nil if the link leads to a file.
local function place(folder, target)
  if target:match('^%a+:') then return target end
  local path, part = target:match('^([^#]*)#?(.*)$')
  local whole = target:match('^#') and folder or (folder .. path):gsub('[^/.]+/%.%./', ''):match('^(.*)README%.md$')
  if not whole or whole:match('^%.%.') or whole:match('^data/') then return nil end
  if not pandoc.List.includes(pages, whole) then table.insert(pages, whole) end
  return '#' .. whole .. (part == '' and 'top' or part)
end

local function adapted(folder)
  local file = assert(io.open(folder .. 'README.md'))
  local blocks = pandoc.read(file:read('a'), 'gfm+tex_math_dollars').blocks
  blocks[1].identifier = 'top'
  return pandoc.walk_block(pandoc.Div(blocks), {
    Header = function(header)
      header.identifier = folder .. header.identifier
      return header
    end,
    Link = function(link)
      local found = place(folder, link.target)
      if not found then return pandoc.Span(link.content, {title = link.target:gsub('^[./]*', '')}) end
      link.target = found
      return link
    end,
    Image = function(image)
      image.src = folder .. image.src
      return image
    end,
    Table = function(table) return pandoc.Div(table, {class = 'scroll'}) end,
  })
end

function Pandoc(document)
  for _, folder in ipairs(pages) do document.blocks:insert(adapted(folder)) end
  document.meta.pagetitle, document.meta.lang = 'nipref: the mathematics of the reference', 'en'
  document.meta['header-includes'] = pandoc.RawBlock('html', style)
  return document
end
