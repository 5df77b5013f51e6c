package org.dronewatch.report.campaign;

import java.util.List;
import java.util.Locale;
import org.dronewatch.campaign.outcome.CampaignSummary;
import org.dronewatch.campaign.outcome.Outcome;
import org.dronewatch.campaign.outcome.PairedDifference;
import org.dronewatch.statistics.Proportion;

/** Shares of cases and outcomes in the words of a report. */
final class ShareWords {
    static final double PERCENT = 100.0;

    private static final double LEAST_P = 0.001;

    private ShareWords() {}

    /** The most demanding outcome that is known for every variant of which any case could be run. */
    static Outcome headline(CampaignSummary summary) {
        for (Outcome outcome : List.of(Outcome.IN_TIME, Outcome.ALERTED)) {
            boolean isKnown = summary.variants().values().stream()
                    .filter(one -> one.failed() < one.cases())
                    .allMatch(one -> one.proportion(outcome).isPresent());
            if (isKnown) {
                return outcome;
            }
        }
        return Outcome.DETECTED;
    }

    /** What a case with the outcome is like, as a clause. */
    static String clause(Outcome outcome) {
        return switch (outcome) {
            case DETECTED -> "the drone is detected";
            case ALERTED -> "an alert is raised";
            case IN_TIME -> "the alert is in time";
        };
    }

    /** The heading of a column. */
    static String name(Outcome outcome) {
        return outcome.name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }

    /** {@code 92.0 % (90.2 to 93.5)}. */
    static String withInterval(Proportion share) {
        return withInterval(share, share.wilson(CampaignFile.CONFIDENCE));
    }

    /** A proportion with a given interval, {@code 92.0 % (90.2 to 93.5)}. */
    static String withInterval(Proportion share, Proportion.Interval interval) {
        return String.format(
                Locale.ROOT,
                "%.1f %% (%.1f to %.1f)",
                PERCENT * share.share(),
                PERCENT * interval.low(),
                PERCENT * interval.high());
    }

    /**
     * {@code +9.8 percentage points (+7.1 to +12.4)}.
     *
     * @param isTurned whether to subtract the first variant from the second instead
     */
    static String difference(PairedDifference difference, boolean isTurned) {
        PairedDifference seen =
                isTurned ? new PairedDifference(difference.onlyB(), difference.onlyA(), difference.of()) : difference;
        Proportion.Interval interval = seen.interval(CampaignFile.CONFIDENCE);
        return String.format(
                Locale.ROOT,
                "%+.1f percentage points (%+.1f to %+.1f)",
                PERCENT * seen.difference(),
                PERCENT * interval.low(),
                PERCENT * interval.high());
    }

    static String p(PairedDifference difference) {
        double p = difference.pValue();
        return p < LEAST_P ? "p below 0.001" : String.format(Locale.ROOT, "p = %.3f", p);
    }
}
