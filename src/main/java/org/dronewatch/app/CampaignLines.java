package org.dronewatch.app;

import java.io.PrintWriter;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.app.console.ExitCode;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.CampaignResult;
import org.dronewatch.campaign.Expectation;
import org.dronewatch.campaign.Sensitivity;
import org.dronewatch.campaign.SensitivityCases;
import org.dronewatch.campaign.Stopping;
import org.dronewatch.campaign.outcome.CampaignSummary;
import org.dronewatch.campaign.outcome.CaseResult;
import org.dronewatch.campaign.outcome.Measures;
import org.dronewatch.campaign.outcome.Outcome;
import org.dronewatch.campaign.outcome.PairedDifference;
import org.dronewatch.campaign.outcome.UntilSettings;
import org.dronewatch.campaign.outcome.VariantComparison;
import org.dronewatch.report.campaign.CampaignWords;
import org.dronewatch.setting.Counted;
import org.dronewatch.statistics.Proportion;

/** Prints the results of the command {@code campaign}, line by line. */
final class CampaignLines {
    private static final double CONFIDENCE = 0.95;
    private static final double PERCENT = 100.0;

    private CampaignLines() {}

    /** The outcomes of all cases. */
    static void print(CampaignPlan plan, CampaignResult result, PrintWriter out) {
        CampaignSummary summary = result.summary();
        int width =
                summary.variants().keySet().stream().mapToInt(String::length).reduce("variant".length(), Math::max);
        out.println("numbers of cases, and percentages of them with 95 % confidence intervals:");
        out.printf(
                "%-" + width + "s %8s %7s %22s %22s %22s%n",
                "variant",
                "cases",
                "failed",
                "detected",
                "alerted",
                "in time");
        summary.variants()
                .forEach((name, one) -> out.printf(
                        "%-" + width + "s %,8d %,7d %22s %22s %22s%n",
                        name,
                        one.cases(),
                        one.failed(),
                        share(one.proportion(Outcome.DETECTED)),
                        share(one.proportion(Outcome.ALERTED)),
                        share(one.proportion(Outcome.IN_TIME))));
        out.printf(
                "%nvalue reached or exceeded in 95 %%, 50 %% and 5 %% of the cases (- where too few have a value):%n");
        out.printf("%-" + width + "s %31s %31s%n", "variant", "range of first detection [m]", "warning [s]");
        summary.variants()
                .forEach((name, one) -> out.printf(
                        "%-" + width + "s %31s %31s%n", name, quantiles(one.ranges()), quantiles(one.warnings())));
        printPairs(summary.comparisons(), out);
        result.sensitivity().ifPresent(sensitivity -> print(sensitivity, out));
        plan.settings().until().ifPresent(until -> printPrecision(plan, until, result.stopping(), out));
    }

    /**
     * Prints what casts doubt on the results.
     *
     * @return the exit code: that of a failure if no case could be run
     */
    static int warn(CampaignSummary summary, PrintWriter err) {
        CampaignWords.doubts(summary).forEach(line -> err.println("warning: " + line));
        if (summary.isAllFailed()) {
            err.println("no case could be run: " + CampaignWords.mostFrequentFailure(summary));
            return ExitCode.FAILED;
        }
        return 0;
    }

    /**
     * Prints which expectations of a campaign are not met.
     *
     * @return the exit code: that of a failure if any is not
     */
    static int judge(CampaignPlan plan, CampaignSummary summary, PrintWriter err) {
        int code = 0;
        for (Expectation one : plan.settings().expect()) {
            if (!one.isMet(plan, summary)) {
                err.println("expectation not met: " + CampaignWords.missed(plan, one, summary));
                code = ExitCode.FAILED;
            }
        }
        return code;
    }

    private static void printPrecision(CampaignPlan plan, UntilSettings until, Stopping stopping, PrintWriter out) {
        Proportion proportion = stopping.proportion();
        Proportion.Interval interval = until.rule().interval(proportion);
        String asked = "'" + word(until.of()) + "' for " + plan.observed() + " to within "
                + CampaignWords.points(until.halfWidth()) + " at "
                + number(PERCENT * until.confidence()) + " % confidence";
        out.println();
        out.println(
                stopping.isPrecise()
                        ? String.format(
                                Locale.ROOT,
                                "%s: %.1f (%.1f to %.1f) %% after %,d cases",
                                asked,
                                PERCENT * proportion.share(),
                                PERCENT * interval.low(),
                                PERCENT * interval.high(),
                                proportion.of())
                        : String.format(Locale.ROOT, "%s: not reached after %,d cases", asked, proportion.of()));
    }

    /** What it costs to find out which settings matter. */
    static String cost(CampaignPlan plan, SensitivityCases cases) {
        int factors = plan.paths().size() + 1;
        int each = cases.size() / cases.settings().base();
        return String.format(
                Locale.ROOT,
                "sensitivity: %,d more cases of %s, %d in each of %,d groups, with %s; the campaign itself has %s",
                cases.size(),
                cases.variants().get(0),
                each,
                cases.settings().base(),
                factors == 1 ? "1 factor (chance)" : factors + " factors, including chance",
                Counted.of((long) plan.size() * plan.variants().size(), "run"));
    }

    private static void print(Sensitivity sensitivity, PrintWriter out) {
        out.println();
        CampaignWords.sensitivity(sensitivity).forEach(out::println);
    }

    private static String number(double value) {
        return BigDecimal.valueOf(value)
                .round(new MathContext(6))
                .stripTrailingZeros()
                .toPlainString();
    }

    private static void printPairs(List<VariantComparison> pairs, PrintWriter out) {
        if (pairs.isEmpty()) {
            return;
        }
        out.printf("%nthe same cases compared:%n");
        for (VariantComparison pair : pairs) {
            PairedDifference difference = pair.difference();
            Proportion.Interval interval = difference.interval(CONFIDENCE);
            out.printf(
                    Locale.ROOT,
                    "%s: %s minus %s = %+.1f points (%+.1f to %+.1f), %s alone in %,d, %s alone in %,d of %,d cases,"
                            + " p = %s%s%n",
                    word(pair.outcome()),
                    pair.a(),
                    pair.b(),
                    PERCENT * difference.difference(),
                    PERCENT * interval.low(),
                    PERCENT * interval.high(),
                    pair.a(),
                    difference.onlyA(),
                    pair.b(),
                    difference.onlyB(),
                    difference.of(),
                    String.format(Locale.ROOT, "%.3g", difference.pValue()),
                    pair.deciding().isEmpty()
                            ? ""
                            : "; first differing case: " + pair.deciding().get(0));
        }
    }

    /** The first cases in which the variants differ in the most demanding outcome, with their values. */
    static void printDeciding(CampaignPlan plan, CampaignSummary summary, PrintWriter out) {
        List<VariantComparison> pairs = summary.comparisons();
        if (pairs.isEmpty()) {
            return;
        }
        VariantComparison pair = pairs.get(pairs.size() - 1);
        int all = pair.difference().onlyA() + pair.difference().onlyB();
        out.println();
        if (all == 0) {
            out.println(
                    "there are no deciding cases: '" + word(pair.outcome()) + "' is the same for both in every case");
            return;
        }
        int width = Math.max(pair.a().length(), pair.b().length());
        out.printf(
                Locale.ROOT,
                "deciding cases (%,d of %,d), each with the only variant whose outcome is '%s':%n",
                pair.deciding().size(),
                all,
                word(pair.outcome()));
        for (int number : pair.deciding()) {
            List<String> values = plan.values(number);
            StringBuilder line = new StringBuilder();
            for (int i = 0; i < values.size(); i++) {
                line.append("  ").append(plan.paths().get(i)).append('=').append(values.get(i));
            }
            out.printf(Locale.ROOT, "%8d  %-" + width + "s%s%n", number, pair.betterIn(number), line);
        }
    }

    private static String word(Outcome outcome) {
        return outcome.name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }

    private static String share(Optional<Proportion> proportion) {
        if (proportion.isEmpty()) {
            return "-";
        }
        Proportion.Interval interval = proportion.get().wilson(CONFIDENCE);
        return String.format(
                Locale.ROOT,
                "%.1f (%.1f to %.1f)",
                PERCENT * proportion.get().share(),
                PERCENT * interval.low(),
                PERCENT * interval.high());
    }

    private static String quantiles(Measures measures) {
        return text(measures.quantile(0.05)) + ", " + text(measures.quantile(0.5)) + ", "
                + text(measures.quantile(0.95));
    }

    private static String text(OptionalDouble value) {
        return value.isPresent() ? String.format(Locale.ROOT, "%.1f", value.getAsDouble()) : "-";
    }

    /** The seed and the values of a case. */
    static void printValues(CampaignPlan plan, int number, PrintWriter out) {
        out.println("case " + number + ", seed " + plan.seed(number));
        List<String> values = plan.values(number);
        int i = 0;
        for (String path : plan.paths()) {
            out.println("  " + path + "=" + values.get(i++));
        }
    }

    /** The outcome of one case. */
    static void print(CaseResult result, PrintWriter out) {
        if (result.isFailed()) {
            out.println(result.variant() + ": failed: " + result.error().orElseThrow());
            return;
        }
        out.println(result.variant() + ": " + CampaignWords.cameOf(result));
    }
}
