package org.dronewatch.report.campaign;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.Expectation;
import org.dronewatch.campaign.Sensitivity;
import org.dronewatch.campaign.outcome.CampaignQuantity;
import org.dronewatch.campaign.outcome.CampaignSummary;
import org.dronewatch.campaign.outcome.CaseResult;
import org.dronewatch.campaign.outcome.FailedCases;
import org.dronewatch.campaign.sensitivity.MorrisEffect;
import org.dronewatch.campaign.sensitivity.SobolIndex;
import org.dronewatch.report.html.ReadableNumbers;
import org.dronewatch.setting.Counted;

/** States the results of campaigns in sentences. */
public final class CampaignWords {
    private static final double PERCENT = 100.0;

    private CampaignWords() {}

    /** Which settings matter: a line for each, the most influential first, and chance last. */
    public static List<String> sensitivity(Sensitivity sensitivity) {
        CampaignQuantity output = sensitivity.settings().output();
        String what = output.words() + " with " + sensitivity.variant();
        List<Sensitivity.Influence> influences = ordered(sensitivity);
        List<String> lines = new ArrayList<>();
        if (influences.isEmpty()) {
            return List.of("what explains the " + what + ": " + withoutInfluences(sensitivity));
        }
        boolean isSobol = influences.get(0).index().isPresent();
        lines.add(
                isSobol
                        ? "what explains the " + what + ", in % of its variance, with 95 % confidence intervals:"
                        : "effect of a change across the whole distribution on the " + what
                                + (output.unit().isEmpty() ? "" : " [" + output.unit() + "]")
                                + ": mean magnitude (mu*), standard deviation (sigma)");
        int width =
                influences.stream().mapToInt(one -> name(one).length()).max().orElseThrow();
        for (Sensitivity.Influence one : influences) {
            lines.add(String.format(Locale.ROOT, "  %-" + width + "s  ", name(one))
                    + one.index()
                            .map(CampaignWords::words)
                            .orElseGet(() -> words(one.effect().orElseThrow())));
        }
        if (sensitivity.failed() > 0) {
            lines.add("  "
                    + Counted.of(
                            sensitivity.failed(),
                            "case failed; its group is left out",
                            "cases failed; their groups are left out"));
        }
        return lines;
    }

    /** Why there are no influences, as a clause. */
    static String withoutInfluences(Sensitivity sensitivity) {
        return sensitivity.isEstimable()
                ? "nothing, because it is the same in all cases"
                : String.format(
                        Locale.ROOT,
                        "not known, because %,d of the %,d further cases failed",
                        sensitivity.failed(),
                        sensitivity.cases());
    }

    /** The influences, the strongest first and chance last. */
    static List<Sensitivity.Influence> ordered(Sensitivity sensitivity) {
        return sensitivity.influences().stream()
                .sorted(Comparator.comparing(Sensitivity.Influence::isChance)
                        .thenComparing(
                                Comparator.comparingDouble(CampaignWords::size).reversed()))
                .toList();
    }

    /** The outcome of one case that did not fail, in words. */
    public static String cameOf(CaseResult result) {
        String detected = result.firstSensor().isEmpty()
                ? "never detected"
                : "first detected after " + text(result.firstDetected()) + " s by "
                        + result.firstSensor().get() + " at " + text(result.range()) + " m";
        String alerted = result.alert().isEmpty()
                ? "no alert" + cameTo(result)
                : "alert after " + text(result.alert()) + " s"
                        + (result.warning().isEmpty() ? "" : ", warning " + text(result.warning()) + " s")
                        + result.inTime()
                                .map(yes -> yes ? ", in time" : ", too late")
                                .orElse("");
        return detected + "; " + alerted;
    }

    /** How near a drone for which there was no alert came to what is protected; empty if nothing is protected. */
    private static String cameTo(CaseResult result) {
        if (result.closest().isEmpty()) {
            return "";
        }
        return result.closest().getAsDouble() == 0.0
                ? "; reached what is protected"
                : "; came within " + text(result.closest()) + " m of what is protected";
    }

    /** Why cases failed, a line for each variant and reason. */
    public static List<String> failures(CampaignSummary summary) {
        List<String> lines = new ArrayList<>();
        summary.variants().forEach((name, variant) -> variant.failures()
                .forEach(reason -> lines.add(String.format(
                        Locale.ROOT,
                        "%s of %s could not be run (%scase %d): %s",
                        Counted.of(reason.cases(), "case"),
                        name,
                        reason.cases() == 1 ? "" : "first: ",
                        reason.example(),
                        reason.words()))));
        return lines;
    }

    /**
     * The most frequent reason for the failure of a case, or the first of several such reasons; empty if no case
     * failed.
     */
    public static String mostFrequentFailure(CampaignSummary summary) {
        return summary.variants().values().stream()
                .flatMap(variant -> variant.failures().stream())
                .reduce((one, other) -> other.cases() > one.cases() ? other : one)
                .map(FailedCases.Reason::words)
                .orElse("");
    }

    /** A line that says that runs end too early; empty if none do. */
    public static Optional<String> cutShort(CampaignSummary summary) {
        String counts = summary.variants().entrySet().stream()
                .filter(one -> one.getValue().cutShort() > 0)
                .map(one -> String.format(
                        Locale.ROOT,
                        "%,d of %,d cases of %s",
                        one.getValue().cutShort(),
                        one.getValue().cases(),
                        one.getKey()))
                .collect(Collectors.joining(", "));
        return counts.isEmpty()
                ? Optional.empty()
                : Optional.of("The run ends too early in " + counts
                        + ": the drone, for which there is no alert yet, is still coming closer; increase"
                        + " run.duration.");
    }

    /** What casts doubt on the results, in lines: cases that failed, and runs that end too early. */
    public static List<String> doubts(CampaignSummary summary) {
        List<String> doubts = new ArrayList<>(failures(summary));
        cutShort(summary).ifPresent(doubts::add);
        return doubts;
    }

    private static String text(OptionalDouble value) {
        return value.isPresent() ? String.format(Locale.ROOT, "%.1f", value.getAsDouble()) : "-";
    }

    /** Why a campaign does not meet an expectation. */
    public static String missed(CampaignPlan plan, Expectation expected, CampaignSummary summary) {
        String what = "'" + expected.of().name().toLowerCase(Locale.ROOT).replace('_', ' ') + "' for "
                + expected.variantIn(plan);
        return expected.proportion(plan, summary)
                .map(one -> String.format(
                        Locale.ROOT,
                        "%s: lower bound %.4f, must be at least %s (%,d of %,d cases)",
                        what,
                        expected.interval(plan, summary).orElseThrow().low(),
                        expected.low(),
                        one.count(),
                        one.of()))
                .orElse(what + ": not known in any of the cases");
    }

    /** A setting by its path, or chance. */
    static String name(Sensitivity.Influence influence) {
        return influence.isChance() ? "chance" : influence.path();
    }

    private static double size(Sensitivity.Influence influence) {
        return influence
                .index()
                .map(SobolIndex::total)
                .orElseGet(() -> influence.effect().orElseThrow().magnitude());
    }

    private static String words(SobolIndex index) {
        return String.format(
                Locale.ROOT,
                "alone %5.1f (%.1f to %.1f), with interactions %5.1f (%.1f to %.1f)",
                percent(index.first()),
                percent(index.low()),
                percent(index.high()),
                percent(index.total()),
                percent(index.totalLow()),
                percent(index.totalHigh()));
    }

    private static String words(MorrisEffect effect) {
        return String.format(Locale.ROOT, "%8.3f, %8.3f", effect.magnitude(), effect.deviation());
    }

    /** A fraction in percent, never -0. */
    static double percent(double part) {
        double percent = PERCENT * part;
        return Math.abs(percent) < 0.05 ? 0.0 : percent;
    }

    /** A difference of probabilities in words: {@code 2 percentage points}. */
    public static String points(double difference) {
        String points = ReadableNumbers.number(ShareWords.PERCENT * difference);
        return points + (points.equals("1") ? " percentage point" : " percentage points");
    }
}
