// Judges the trace of a run from outside: it knows the file's columns and the machine's limits in
// plain numbers, and shares no code with the kernel.
//
//   hour_judge FACTS TRACE.csv        prints a line for each fault, then "judged N ticks"; exit 1
//                                     when there was a fault
//
// FACTS, a line each (times in seconds, mm or degrees):
//   tick S
//   axis NUMBER CHANNEL VMAX AMAX JMAX LOW HIGH ESTOP_DEC FOLLOWING RESTING
//   free NUMBER FROM TO     what the axis' command does is nobody's doing then (off, open loop,
//                           coordinates shifted)
//   hard FROM TO            emergency stop: ESTOP_DEC holds instead of AMAX, no jerk limit
//   still CHANNEL FROM TO   the channel may stand without moving (override 0, a reason was named)
//   at T NUMBER VALUE       the path went through here
//   tie SLAVE MASTER SIGN FROM TO BY   the slave's command goes the master's way, to BY mm
//   add SLAVE MASTER SIGN FROM TO      the master's way since FROM is added to what the slave's own
//                                      program says
//   patience S              a channel that runs and neither moves nor has a reason hangs after so
//                           long
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {
struct Span {
    double from, to;
};
bool inside(const std::vector<Span>& spans, double t) {
    return std::any_of(spans.begin(), spans.end(),
                       [t](const Span& s) { return t >= s.from && t <= s.to; });
}

struct Axis {
    int number = 0, channel = 0;
    double vmax = 0, amax = 0, jmax = 0, low = 0, high = 0, estop = 0, following = 0, resting = 0;
    std::vector<Span> free;
    std::multimap<double, double> at;
    std::size_t cmd = 0, act = 0;  // columns
    double p = 0, v = 0, a = 0;    // of the tick before
    int known = 0;                 // how many of them are
    double still_s = 0, said_s = -1, added = 0;
    std::map<std::string, int> told;
};
struct Channel {
    std::vector<Span> still;
    std::size_t column = 0;
    double standing_s = 0;
    bool exists = false, told = false;
};

// A slave and its master. What its program commanded is known at `from` and after each time that
// nobody commanded it.
struct Coupling {
    int slave = 0, master = 0;
    double sign = 1, from = 0, to = 0, by = 0;
    bool adds = false, known = false;
    double reference = 0;  // tie: slave - sign * master; add: the master
};

struct Judge {
    std::vector<Coupling> couplings;
    double tick = 0.001, timeout = 30;
    std::map<int, Axis> axes;
    std::map<int, Channel> channels;
    std::vector<Span> hard;
    int faults = 0;

    void fault(Axis& axis, double t, const char* what, double value, double limit) {
        ++faults;
        if (axis.told[what]++ < 3)
            std::printf("t=%.3f A%d: %s %.9g, allowed %.9g\n", t, axis.number, what, value, limit);
    }

    bool read_facts(const char* file) {
        std::ifstream in(file);
        if (!in) return false;
        std::string line, word;
        while (std::getline(in, line)) {
            std::istringstream row(line);
            row >> word;
            int n = 0;
            Span s{};
            if (word == "tick")
                row >> tick;
            else if (word == "patience")
                row >> timeout;
            else if (word == "axis") {
                Axis a;
                row >> a.number >> a.channel >> a.vmax >> a.amax >> a.jmax >> a.low >> a.high >>
                    a.estop >> a.following >> a.resting;
                axes[a.number] = a;
            } else if (word == "free") {
                row >> n >> s.from >> s.to;
                axes[n].free.push_back(s);
            } else if (word == "hard") {
                row >> s.from >> s.to;
                hard.push_back(s);
            } else if (word == "still") {
                row >> n >> s.from >> s.to;
                channels[n].still.push_back(s);
            } else if (word == "tie" || word == "add") {
                Coupling c;
                c.adds = word == "add";
                row >> c.slave >> c.master >> c.sign >> c.from >> c.to;
                if (!c.adds) row >> c.by;
                couplings.push_back(c);
            } else if (word == "at") {
                double t = 0, value = 0;
                row >> t >> n >> value;
                axes[n].at.emplace(t, value);
            }
            if (!row) {
                std::fprintf(stderr, "bad line: %s\n", line.c_str());
                return false;
            }
        }
        return true;
    }

    // Before the axes themselves are looked at: `cmd` of both in this tick.
    void look_at_couplings(double t, const std::vector<double>& cell) {
        for (auto& [number, axis] : axes) axis.added = 0;
        for (Coupling& c : couplings) {
            Axis &slave = axes[c.slave], &master = axes[c.master];
            if (t < c.from || t > c.to - 1.5 * tick || inside(slave.free, t) ||
                inside(master.free, t)) {
                c.known = c.known && c.adds && t >= c.from;
                continue;
            }
            const double s = cell[slave.cmd], m = cell[master.cmd];
            if (!c.known) c.reference = c.adds ? m : s - c.sign * m;
            c.known = true;
            if (c.adds)
                slave.added += c.sign * (m - c.reference);
            else if (std::fabs(s - c.sign * m - c.reference) > c.by)
                fault(slave, t, "apart from its master by", s - c.sign * m - c.reference, c.by);
        }
    }
    void look(Axis& axis, double t, double cmd, double act, bool braking) {
        if (!std::isfinite(cmd) || !std::isfinite(act)) return fault(axis, t, "no number", cmd, 0);
        if (inside(axis.free, t)) {
            axis.known = 0;
            axis.p = cmd;
            axis.still_s = 0;
            return;
        }
        constexpr double kMore = 1.01;
        if (cmd > axis.high + 1e-6) fault(axis, t, "beyond its upper end", cmd, axis.high);
        if (cmd < axis.low - 1e-6) fault(axis, t, "beyond its lower end", cmd, axis.low);
        if (axis.known >= 1) {
            const double v = (cmd - axis.p) / tick;
            if (std::fabs(v) > axis.vmax * kMore) fault(axis, t, "speed", v, axis.vmax);
            if (axis.known >= 2) {
                const double a = (v - axis.v) / tick,
                             most = braking ? std::max(axis.amax, axis.estop) : axis.amax;
                if (std::fabs(a) > most * kMore) fault(axis, t, "acceleration", a, most);
                if (axis.known >= 3 && !braking) {
                    const double j = (a - axis.a) / tick;
                    if (std::fabs(j) > axis.jmax * kMore) fault(axis, t, "jerk", j, axis.jmax);
                }
                axis.a = a;
            }
            axis.still_s = v == 0 ? axis.still_s + tick : 0;
            axis.v = v;
        }
        axis.known = std::min(axis.known + 1, 3);
        axis.p = cmd;
        if (braking) axis.still_s = 0;  // a drive that has failed stops as it can
        if (!braking && std::fabs(cmd - act) > axis.following)
            fault(axis, t, "measured away from its command by", cmd - act, axis.following);
        if (axis.still_s > 0.5 && std::fabs(cmd - act) > axis.resting)
            fault(axis, t, "at rest away from its command by", cmd - act, axis.resting);
        // The path's points: near in time, the command was there. A blend rounds a corner a little.
        const double slack = 0.02 + 3 * tick * std::fabs(axis.v);
        for (auto it = axis.at.lower_bound(t - tick); it != axis.at.end() && it->first < t;
             it = axis.at.erase(it))
            if (axis.known >= 2 && std::fabs(cmd - axis.added - it->second) > slack)
                fault(axis, t, "not where its path led:", cmd - axis.added - it->second, slack);
    }

    int run(const char* file) {
        std::ifstream in(file);
        std::string line;
        if (!in || !std::getline(in, line)) {
            std::fprintf(stderr, "no trace %s\n", file);
            return 2;
        }
        std::istringstream head(line);
        std::string name;
        for (std::size_t column = 0; std::getline(head, name, ','); ++column) {
            const int number = name.size() > 1 ? std::atoi(name.c_str() + 1) : 0;
            const auto dot = name.find('.');
            const std::string what = dot == std::string::npos ? "" : name.substr(dot + 1);
            if (name[0] == 'A' && axes.count(number))
                (what == "cmd" ? axes[number].cmd : axes[number].act) = column;
            if (name[0] == 'L') {
                channels[number].column = column;
                channels[number].exists = true;
            }
        }
        std::vector<double> cell;
        double before = -1;
        long ticks = 0;
        while (std::getline(in, line)) {
            cell.clear();
            for (const char *p = line.data(), *end = p + line.size(); p < end;) {
                double value = NAN;
                const auto got = std::from_chars(p, end, value);
                cell.push_back(value);
                p = got.ptr;
                while (p < end && *p != ',') ++p;
                ++p;
            }
            const double t = cell[0];
            const bool gap = before >= 0 && t - before > 1.5 * tick;
            const bool braking = inside(hard, t);
            std::map<int, bool> moves;
            look_at_couplings(t, cell);
            for (auto& [number, axis] : axes) {
                if (axis.cmd >= cell.size() || axis.act >= cell.size()) continue;
                if (gap) {
                    if (axis.known && cell[axis.cmd] != axis.p && !inside(axis.free, t))
                        fault(axis, t, "moved while time stood:", cell[axis.cmd] - axis.p, 0);
                    axis.known = 0;
                }
                const double was = axis.p;
                look(axis, t, cell[axis.cmd], cell[axis.act], braking);
                moves[axis.channel] = moves[axis.channel] || cell[axis.cmd] != was;
            }
            for (auto& [number, channel] : channels) {
                if (!channel.exists || channel.column >= cell.size()) continue;
                constexpr int kRunning = 2;
                const bool stands = static_cast<int>(cell[channel.column]) == kRunning &&
                                    !moves[number] && !inside(channel.still, t);
                channel.standing_s = stands ? channel.standing_s + tick : 0;
                if (channel.standing_s > timeout && !channel.told) {
                    channel.told = true;
                    ++faults;
                    std::printf("t=%.3f L%d: runs, does not move and has no reason since %.1f s\n",
                                t, number, channel.standing_s);
                }
            }
            before = t;
            ++ticks;
        }
        for (auto& [number, axis] : axes)
            for (const auto& [what, count] : axis.told)
                if (count > 3)
                    std::printf("A%d: %s, %d times in all\n", number, what.c_str(), count);
        std::printf("judged %ld ticks\n", ticks);
        return faults ? 1 : 0;
    }
};
}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: hour_judge FACTS TRACE.csv\n");
        return 2;
    }
    Judge judge;
    if (!judge.read_facts(argv[1])) {
        std::fprintf(stderr, "cannot read %s\n", argv[1]);
        return 2;
    }
    return judge.run(argv[2]);
}
