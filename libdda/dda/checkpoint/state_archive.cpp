#include "dda/checkpoint/state_archive.hpp"

#include <cstring>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace rockslope::dda {

namespace {

/// Writer and Reader visit the same list of fields. The structured bindings below name every member: a member
/// added to one of these structs does not compile until it is listed.
class Writer {
  public:
    explicit Writer(StateArchive& archive) : archive_(archive) {}

    void real(const double& value) { archive_.reals.push_back(value); }
    template <class Integer>
    void integer(const Integer& value) {
        archive_.integers.push_back(static_cast<std::int64_t>(value));
    }
    template <class Kind>
    void integer(const Index<Kind>& index) {
        archive_.integers.push_back(index.value());
    }
    void size(std::size_t value) { integer(value); }
    template <class Vector>
    std::size_t resize(const Vector& vector) {
        integer(vector.size());
        return vector.size();
    }
    void history(const JointHistory& history) {
        integer(history.index());
        std::visit(
            [&](const auto& value) {
                static_assert(std::is_trivially_copyable_v<std::decay_t<decltype(value)>>,
                              "a joint history is plain data");
                const auto* first = reinterpret_cast<const std::uint8_t*>(&value);
                archive_.bytes.insert(archive_.bytes.end(), first, first + sizeof value);
            },
            history);
    }

  private:
    StateArchive& archive_;
};

class Reader {
  public:
    explicit Reader(const StateArchive& archive) : archive_(archive) {}

    void real(double& value) { value = next(archive_.reals, real_); }
    template <class Integer>
    void integer(Integer& value) {
        value = static_cast<Integer>(next(archive_.integers, integer_));
    }
    template <class Vector>
    std::size_t resize(Vector& vector) {
        const std::int64_t size = next(archive_.integers, integer_);
        if (size < 0 || std::cmp_greater(size, archive_.reals.size() + archive_.integers.size())) fail();
        vector.resize(size);
        return vector.size();
    }
    void history(SharedHistory& shared) {
        JointHistory history;
        make_history(next(archive_.integers, integer_), history,
                     std::make_index_sequence<std::variant_size_v<JointHistory>>{});
        shared = history;
    }
    void finish() const {
        if (real_ != archive_.reals.size() || integer_ != archive_.integers.size() ||
            byte_ != archive_.bytes.size())
            fail();
    }

  private:
    [[noreturn]] static void fail() {
        throw std::runtime_error("its state has another layout than that of this program");
    }
    template <class T>
    static T next(const std::vector<T>& values, std::size_t& at) {
        if (at >= values.size()) fail();
        return values[at++];
    }
    template <std::size_t... I>
    void make_history(std::size_t index, JointHistory& history, std::index_sequence<I...>) {
        const bool known = ((index == I && (read_history<I>(history), true)) || ...);
        if (!known) fail();
    }
    template <std::size_t I>
    void read_history(JointHistory& history) {
        std::variant_alternative_t<I, JointHistory> value;
        if (byte_ + sizeof value > archive_.bytes.size()) fail();
        std::memcpy(static_cast<void*>(&value), archive_.bytes.data() + byte_, sizeof value);
        byte_ += sizeof value;
        history = value;
    }

    const StateArchive& archive_;
    std::size_t real_ = 0, integer_ = 0, byte_ = 0;
};

template <class Walker, class... Values>
void reals(Walker& walker, Values&... values) {
    (walker.real(values), ...);
}
template <class Walker, class... Values>
void integers(Walker& walker, Values&... values) {
    (walker.integer(values), ...);
}
template <class Walker, class Vector>
void components(Walker& walker, Vector& vector) {
    for (int i = 0; i < vector.size(); ++i) walker.real(vector[i]);
}
template <class Walker, class Vectors>
void all_components(Walker& walker, Vectors& vectors) {
    walker.resize(vectors);
    for (auto& vector : vectors) components(walker, vector);
}
template <class Walker, class Numbers>
void all_reals(Walker& walker, Numbers& numbers) {
    walker.resize(numbers);
    for (auto& number : numbers) walker.real(number);
}

template <class Walker, class M>
void moments(Walker& walker, M& value) {
    auto& [area, centroid, xx, yy, xy] = value;
    reals(walker, area, xx, yy, xy);
    components(walker, centroid);
}

template <class Walker, class B>
void blocks(Walker& walker, B& value) {
    auto& [vertices, points, all_moments, mass, rotation, stress, velocity, acceleration] = value;
    all_components(walker, vertices);
    all_components(walker, points);
    walker.resize(all_moments);
    for (auto& m : all_moments) moments(walker, m);
    all_reals(walker, mass);
    all_reals(walker, rotation);
    all_components(walker, stress);
    all_components(walker, velocity);
    all_components(walker, acceleration);
}

template <class Walker, class C>
void contact(Walker& walker, C& value) {
    auto& [point, normal, tangent, corner, edge, corner_block, edge_block, joint_material, joint, group, line,
           kind, state, inhibited, bonded, inherited_penetration, length, gap, dilation, stress_free_gap,
           normal_force, normal_spring_force, shear_force, slip, bond_strain, joint_share, spring_share,
           history] = value;
    integers(walker, corner, edge, corner_block, edge_block, kind, joint_material, joint, group, line,
             inhibited, state, bonded);
    reals(walker, inherited_penetration, length, gap, dilation, stress_free_gap, normal_force,
          normal_spring_force, shear_force, slip, bond_strain, joint_share, spring_share);
    components(walker, point);
    components(walker, normal);
    components(walker, tangent);
    walker.history(history);
}

template <class Walker, class C>
void contacts(Walker& walker, C& value) {
    auto& [all, candidates, candidate_distance, reference] = value;
    walker.resize(all);
    for (auto& one : all) contact(walker, one);
    walker.resize(candidates);
    for (auto& [corner, edge] : candidates) integers(walker, corner, edge);
    reals(walker, candidate_distance);
    all_components(walker, reference);
}

template <class Walker, class C>
void column(Walker& walker, C& value) {
    auto& [displacement, velocity, acceleration] = value;
    all_components(walker, displacement);
    all_components(walker, velocity);
    all_components(walker, acceleration);
}

template <class Walker, class G>
void energy_gain(Walker& walker, G& value) {
    auto& [amount, time, corner_block, edge_block, joint_material] = value;
    reals(walker, amount, time);
    integers(walker, corner_block, edge_block, joint_material);
}

template <class Walker, class E>
void energy(Walker& walker, E& value) {
    auto& [kinetic, strain, contact_energy, constraint, gravity, friction_loss, damping_loss,
           contact_damping_loss, numerical_loss, released, boundary_loss, excavated, external_work,
           initial_stores, friction_returned, largest_gain, largest_spring_gain] = value;
    reals(walker, kinetic, strain, contact_energy, constraint, gravity, friction_loss, damping_loss,
          contact_damping_loss, numerical_loss, released, boundary_loss, excavated, external_work,
          initial_stores, friction_returned);
    energy_gain(walker, largest_gain);
    energy_gain(walker, largest_spring_gain);
}

template <class Walker, class S>
void state_of_blocks(Walker& walker, S& value) {
    auto& [time, stage_time, dynamic_time, next_step, step_count, stage_steps, short_steps, all_blocks,
           displacement_origin, centroid_origin, vertex_origin, stage_origin, bolt_force, boundary_reactions,
           free_fields, ledger, broken_bonds, strained_bonds, lost_blocks, deepest_contact, removed] = value;
    reals(walker, time, stage_time, dynamic_time, next_step);
    auto& [broken_contacts, breaking_events] = broken_bonds;
    auto& [strained_contacts, bonded_contacts] = strained_bonds;
    integers(walker, step_count, stage_steps, short_steps, broken_contacts, breaking_events,
             strained_contacts, bonded_contacts);
    blocks(walker, all_blocks);
    all_components(walker, displacement_origin);
    all_components(walker, centroid_origin);
    all_components(walker, vertex_origin);
    all_components(walker, stage_origin);
    all_reals(walker, bolt_force);
    all_components(walker, boundary_reactions);
    walker.resize(free_fields);
    for (auto& field : free_fields) column(walker, field);
    energy(walker, ledger);
    walker.resize(lost_blocks);
    for (auto& [block, left_at, centroid] : lost_blocks) {
        integers(walker, block);
        reals(walker, left_at);
        components(walker, centroid);
    }
    auto& [share, depth, deepest_at, corner_block, edge_block] = deepest_contact;
    reals(walker, share, depth, deepest_at);
    integers(walker, corner_block, edge_block);
    walker.resize(removed);
    for (auto& flag : removed) walker.integer(flag);
}

}  // namespace

StateArchive archive(const State& value) {
    StateArchive result;
    Writer writer(result);
    state_of_blocks<Writer, const StateWithoutContacts>(writer, value);
    contacts(writer, value.contacts);
    return result;
}

State restore(const StateArchive& archive) {
    State result;
    Reader reader(archive);
    state_of_blocks<Reader, StateWithoutContacts>(reader, result);
    contacts(reader, result.contacts);
    reader.finish();
    return result;
}

}  // namespace rockslope::dda
