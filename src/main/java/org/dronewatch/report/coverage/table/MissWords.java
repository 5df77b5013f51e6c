package org.dronewatch.report.coverage.table;

import static org.dronewatch.report.html.ReadableNumbers.measured;
import static org.dronewatch.report.html.ReadableNumbers.number;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronewatch.analysis.survey.GapEvidence;
import org.dronewatch.report.html.BlockerWords;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Outline;
import org.dronewatch.sensor.Outlined;
import org.dronewatch.sensor.SensorSettings;

/** Describes why a sensor does not cover a gap: what hides the drone, and by how much its signal is too weak. */
final class MissWords {
    /** What hides a drone is named up to this number of times, the most frequent first. */
    private static final int MOST_NAMES = 3;

    /** A value below this is written as less than 0.1, dB. */
    private static final double LEAST_SHOWN = 0.05;

    /** Percentages of at least this are rounded to 100, which represents all cells. */
    private static final double MOST_ROUNDED = 99.5;

    private static final String DECIBELS = "dB";

    private final GapEvidence evidence;
    private final SensorSettings<?> settings;

    MissWords(GapEvidence evidence, SensorSettings<?> settings) {
        this.evidence = evidence;
        this.settings = settings;
    }

    /** All causes, the most frequent first: {@code 80 %: too quiet by 2.1 to 9 dB; 20 %: hidden by house.obj}. */
    String inWords() {
        int all =
                evidence.causes().values().stream().mapToInt(Integer::intValue).sum();
        List<Map.Entry<Cause, Integer>> sorted =
                new ArrayList<>(evidence.causes().entrySet());
        sorted.sort(Map.Entry.comparingByValue(Comparator.reverseOrder()));
        if (sorted.size() == 1) {
            return of(sorted.get(0).getKey());
        }
        return sorted.stream()
                .map(one -> percent(one.getValue(), all) + ": " + of(one.getKey()))
                .collect(Collectors.joining("; "));
    }

    /** A fraction of cells: 100 % only for all of them. */
    static String percent(int cells, int of) {
        double percent = 100.0 * cells / of;
        if (cells < of && percent >= MOST_ROUNDED) {
            return "more than 99 %";
        }
        return percent < 1.0 ? "less than 1 %" : String.format(Locale.ROOT, "%.0f %%", percent);
    }

    private List<GapEvidence.Examined> with(Cause cause) {
        return evidence.examined().stream()
                .filter(one -> one.assessment().cause() == cause)
                .toList();
    }

    private String of(Cause cause) {
        return switch (cause) {
            case HIDDEN_BY_TERRAIN, HIDDEN_BY_BUILDING, HIDDEN_BY_VEGETATION, HIDDEN_BY_OTHER -> {
                String names = blockers(evidence.examined(), cause);
                yield CoverageTable.name(cause) + (names.isEmpty() ? "" : " (" + names + ")");
            }
            case TOO_WEAK -> weak();
            case OUT_OF_RANGE -> CoverageTable.name(cause) + ranges();
            case TOO_SLOW, TOO_FAST -> CoverageTable.name(cause) + speed(cause);
            case DETECTED -> CoverageTable.TOO_RARELY + probabilities();
            case UNKNOWN -> "unknown: the line of sight leaves the known ground";
            case OUT_OF_VIEW, SILENT -> CoverageTable.name(cause);
        };
    }

    /** What hides the drone for one cause, the most frequent first; empty where no examined cell has it. */
    static String blockers(List<GapEvidence.Examined> examined, Cause cause) {
        Map<String, Integer> names = new LinkedHashMap<>();
        examined.stream().filter(one -> one.assessment().cause() == cause).forEach(one -> one.blocker()
                .ifPresent(blocker -> names.merge(BlockerWords.name(blocker), 1, Integer::sum)));
        List<Map.Entry<String, Integer>> sorted = new ArrayList<>(names.entrySet());
        sorted.sort(Map.Entry.comparingByValue(Comparator.reverseOrder()));
        String first = sorted.stream()
                .limit(MOST_NAMES)
                .map(Map.Entry::getKey)
                .filter(name -> !name.isEmpty())
                .collect(Collectors.joining(", "));
        return first + (sorted.size() > MOST_NAMES ? " and others" : "");
    }

    private String weak() {
        List<Assessment> weak = with(Cause.TOO_WEAK).stream()
                .map(GapEvidence.Examined::assessment)
                .filter(one -> Double.isFinite(one.marginDb()))
                .sorted(Comparator.comparingDouble(Assessment::marginDb))
                .toList();
        String words = settings.description().weakness();
        if (weak.isEmpty()) {
            return words + (with(Cause.TOO_WEAK).isEmpty() ? "" : ": nothing measurable reaches the sensor");
        }
        Assessment best = weak.get(weak.size() - 1);
        String least = decibels(best);
        String most = decibels(weak.get(0));
        String missing = best.unit().equals(DECIBELS)
                ? " by " + (least.equals(most) ? least : least + " to " + most) + " dB"
                : "";
        return words + missing + " (at best " + measured(best.quantity(), best.unit()) + ", threshold "
                + measured(best.threshold(), best.unit()) + ")";
    }

    /** The missing margin in words; it is never 0. */
    private static String decibels(Assessment one) {
        double missing = Math.abs(one.marginDb());
        return missing < LEAST_SHOWN ? "less than 0.1" : String.format(Locale.ROOT, "%.1f", missing);
    }

    /** The best margin of an examined cell in which the signal is too weak, dB; minus infinity without one. */
    double bestMargin() {
        return with(Cause.TOO_WEAK).stream()
                .mapToDouble(one -> one.assessment().marginDb())
                .filter(Double::isFinite)
                .max()
                .orElse(Double.NEGATIVE_INFINITY);
    }

    private String speed(Cause cause) {
        return limits(cause)
                .findFirst()
                .map(value -> " (limit: " + number(value) + " m/s)")
                .orElse("");
    }

    /** A drone may be too near or too far; some are too near, and some too far. */
    private String ranges() {
        double least = Outlined.outline(settings)
                .filter(Outline.Sector.class::isInstance)
                .map(Outline.Sector.class::cast)
                .map(Outline.Sector::minRange)
                .orElse(Double.NaN);
        String words = limits(Cause.OUT_OF_RANGE)
                .distinct()
                .sorted()
                .map(value -> (value.equals(least) ? "nearer than " : "beyond ") + number(value) + " m")
                .collect(Collectors.joining(", or "));
        return words.isEmpty() ? "" : " (" + words + ")";
    }

    private Stream<Double> limits(Cause cause) {
        return with(cause).stream()
                .flatMap(one -> one.assessment().limit().stream().boxed());
    }

    private String probabilities() {
        return with(Cause.DETECTED).stream()
                .map(one -> one.assessment().probability())
                .max(Comparator.naturalOrder())
                .map(most -> String.format(Locale.ROOT, " (at most %.2f in one look)", most))
                .orElse("");
    }
}
