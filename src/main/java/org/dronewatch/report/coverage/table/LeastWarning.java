package org.dronewatch.report.coverage.table;

import java.util.Comparator;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleFunction;
import java.util.stream.IntStream;
import org.dronewatch.analysis.field.Warning;
import org.dronewatch.report.CompassPoint;

/**
 * The shortest warning time of some inbound flights, and all flights whose warning time is the same once rounded for
 * printing.
 *
 * @param time the warning time in words; empty where the drone arrives undetected
 * @param isFromStart whether the time is a lower bound
 * @param flights the flights with this warning time, in the order in which they were given
 * @param of number of all flights
 */
public record LeastWarning(String time, boolean isFromStart, List<Warning> flights, int of) {
    /**
     * The shortest warning time of the given flights; an undetected arrival counts as the shortest.
     *
     * @param all at least one flight
     * @param words formats a time, s
     */
    public static LeastWarning of(List<Warning> all, DoubleFunction<String> words) {
        Warning least = all.stream()
                .min(Comparator.comparingDouble(one -> one.time().orElse(-1.0)))
                .orElseThrow();
        String time = words(least, words);
        List<Warning> same =
                all.stream().filter(one -> words(one, words).equals(time)).toList();
        return new LeastWarning(time, same.stream().allMatch(Warning::isFromStart), same, all.size());
    }

    /**
     * In words, the shortest warning time over the bearings with a warning: {@code 12.4 s or more}, or {@code 12.4 s}
     * if only one bearing has a warning; empty if all bearings have a warning, or none has. A no-break space separates
     * the number from its unit.
     *
     * @param words formats a time, s
     */
    public static Optional<String> ofOthers(List<Warning> all, DoubleFunction<String> words) {
        DoubleSummaryStatistics times =
                all.stream().flatMapToDouble(one -> one.time().stream()).summaryStatistics();
        return times.getCount() == 0 || times.getCount() == all.size()
                ? Optional.empty()
                : Optional.of(
                        words.apply(times.getMin()).replace(' ', '\u00a0') + (times.getCount() == 1 ? "" : " or more"));
    }

    private static String words(Warning one, DoubleFunction<String> words) {
        return one.time().isPresent() ? words.apply(one.time().getAsDouble()) : "";
    }

    /** Whether there is no shortest warning time, because a drone arrives undetected. */
    public boolean isNone() {
        return time.isEmpty();
    }

    /**
     * The bearings, clockwise, such as {@code from 350 to 20 deg}, {@code from all bearings but 160 deg}, {@code from
     * all bearings} or {@code from 7 of 36 bearings}. If a drone arrives undetected, {@code from any bearing} or
     * {@code except from 160 deg}.
     *
     * @param all all flights at a height, clockwise from north
     */
    String bearings(List<Warning> all) {
        int count = flights.size();
        if (count == of && count > 1) {
            return isNone() ? "from any bearing" : "from all bearings";
        }
        int[] starts = starts(all);
        if (starts.length > 1) {
            return "from " + count + " of " + of + " bearings";
        }
        int first = starts.length == 0 ? 0 : starts[0];
        return isMostOfACircle(all)
                ? (isNone() ? "except from " : "from all bearings but ") + arc(all, first + count, of - count)
                : "from " + arc(all, first, count);
    }

    /** Whether the drone arrives undetected except from the bearings of an arc, which {@link #bearings} names. */
    boolean isNoneExcept(List<Warning> all) {
        return isNone() && isMostOfACircle(all);
    }

    /**
     * Whether the bearings form one arc of more than half a turn, whose two ends would suggest the other arc between
     * them.
     */
    private boolean isMostOfACircle(List<Warning> all) {
        return 2 * flights.size() > of && flights.size() < of && starts(all).length == 1;
    }

    /** The indices at which arcs of these flights begin: the flight before is not one of them. */
    private int[] starts(List<Warning> all) {
        return IntStream.range(0, of)
                .filter(i -> flights.contains(all.get(i)) && !flights.contains(all.get((i + of - 1) % of)))
                .toArray();
    }

    private static String arc(List<Warning> all, int first, int count) {
        String from = degrees(all.get(first % all.size()));
        return count == 1 ? from + " deg" : from + " to " + degrees(all.get((first + count - 1) % all.size())) + " deg";
    }

    private static String degrees(Warning one) {
        return String.valueOf(Math.round(Math.toDegrees(one.bearing())));
    }

    /** In a sentence: {@code the north}, {@code every bearing}, {@code any bearing} or {@code 7 of 36 bearings}. */
    public String directions() {
        if (flights.size() == 1) {
            return "the " + CompassPoint.of(flights.get(0).bearing());
        }
        if (flights.size() == of) {
            return isNone() ? "any bearing" : "every bearing";
        }
        return flights.size() + " of " + of + " bearings";
    }
}
