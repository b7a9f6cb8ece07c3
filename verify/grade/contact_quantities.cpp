#include <mutex>

#include <nipref/data/scene/results.hpp>
#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/golden/contacts.hpp>
#include <nipref/verify/grade/measured_points.hpp>
#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/support/internal/cache.hpp>

namespace nipref::verify {
namespace {

Argument key_of(const Axis& axis) {
  Argument argument{axis.name, ArgumentKind::nonnegative, {}, {}};
  if (axis.values.front().shown.starts_with('[')) {
    argument.kind = ArgumentKind::choice;
    argument.choices = mapped(axis.values, &AxisValue::shown);
  }
  return argument;
}

/// A kind of contacts, with a cache of the reference's solutions.
class SolvedKind {
 public:
  explicit SolvedKind(const std::string& name) : text_(contact_scene(name)) {
    const AxesProduct sweep = swept_by(text_);
    arguments_ = mapped(sweep.axes(), key_of);
    const data::Scene scene = scene_at(point_of(sweep, 0));
    for (std::size_t i = 0; i < scene.wanted.size(); ++i) {
      const data::SceneResult& result = data::scene_result(scene.wanted[i]);
      Quantity& quantity = quantities_.emplace_back();
      quantity.name = fmt::format("{}.{}", name, result.name);
      quantity.definition = result.meaning;
      quantity.scale = data::text(result.scale);
      quantity.unit = result.unit;
      quantity.arguments = arguments_;
      quantity.promise = scene.accuracy / std::numeric_limits<double>::epsilon();
      quantity.by_ref = [this, i](std::span<const ref::Exact> x, int) {
        return solved(mapped(x, &ref::Exact::approximate))->results[i].numbers.front();
      };
      quantity.by_fast = [this, i](std::span<const double> x, fast::Accuracy) {
        return solve(scene_at(x)).results[i].numbers.front().value;
      };
      quantity.envelope = [this, i](std::span<const double> x) {
        const auto contact = solved(x);
        return static_cast<double>(contact->results[i].allowed.front() / contact->accuracy);
      };
    }
  }

  [[nodiscard]] const std::vector<Quantity>& quantities() const { return quantities_; }

  [[nodiscard]] Point point_of(const AxesProduct& contacts, std::size_t number) const {
    const Assignments keys = contacts.assignments(number, &AxisValue::exact);
    for (const auto& [key, value] : keys) {
      if (std::ranges::find(arguments_, key, &Argument::name) == arguments_.end())
        refuse(key, value, "must be left out: only {} vary",
               fmt::join(mapped(arguments_, &Argument::name), ", "));
    }
    return mapped(arguments_, [&](const Argument& argument) {
      const std::string& text =
          std::ranges::find(keys, argument.name, &Assignments::value_type::first)->second;
      return argument.kind == ArgumentKind::choice ? choice_number(argument, text)
                                                   : parse_real(argument.name, text);
    });
  }

 private:
  [[nodiscard]] data::Scene scene_at(std::span<const double> x) const {
    Assignments keys;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Argument& argument = arguments_[i];
      keys.emplace_back(argument.name, argument.kind == ArgumentKind::choice ? argument.choice(x[i])
                                                                             : fmt::format("{}", x[i]));
    }
    return data::load_scene(text_, keys);
  }
  [[nodiscard]] std::shared_ptr<const SceneSolution<ref::Estimate>> solved(std::span<const double> x) const {
    return solved_.at({x.begin(), x.end()}, [&] { return solve_by_ref(scene_at(x), contact_digits); });
  }

  data::SceneText text_;
  std::vector<Argument> arguments_;
  std::vector<Quantity> quantities_;
  mutable Cache<Point, SceneSolution<ref::Estimate>> solved_;
};

const SolvedKind& kind_of(const std::string& name) {
  static std::mutex mutex;
  static std::map<std::string, SolvedKind> solved;
  const std::lock_guard lock(mutex);
  return solved.try_emplace(name, name).first->second;
}

}  // namespace

const std::vector<Quantity>& contact_quantities(const std::string& kind) {
  return kind_of(kind).quantities();
}

std::vector<Point> contact_points(const std::string& kind, const AxesProduct& contacts) {
  return mapped(std::views::iota(std::size_t{0}, contacts.size()),
                [&](std::size_t i) { return kind_of(kind).point_of(contacts, i); });
}

}  // namespace nipref::verify
