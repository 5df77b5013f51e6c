package org.dronewatch.report.campaign;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.dronewatch.campaign.outcome.CampaignSummary;
import org.dronewatch.campaign.outcome.Measures;
import org.dronewatch.campaign.outcome.Outcome;
import org.dronewatch.campaign.outcome.VariantSummary;
import org.dronewatch.report.html.Html;
import org.dronewatch.report.html.Rose;
import org.dronewatch.statistics.Proportion;

/** The variants of a campaign in tables and figures. */
final class VariantTables {
    private static final double SECTOR = 2.0 * Math.PI / VariantSummary.SECTORS;

    /** With fewer sectors than this there is no line around the middle. */
    private static final int LEAST_SECTORS = 3;

    private static final String NONE = "-";

    private final CampaignSummary summary;
    private final Outcome headline;

    VariantTables(CampaignSummary summary) {
        this.summary = summary;
        this.headline = ShareWords.headline(summary);
    }

    /** How often each outcome occurs, and the most demanding one as bars. */
    String shares() {
        List<String> head = new ArrayList<>(List.of("variant", "cases", "failed"));
        for (Outcome outcome : Outcome.values()) {
            head.add(ShareWords.name(outcome));
        }
        List<List<String>> rows = new ArrayList<>();
        IntervalBars bars = new IntervalBars(
                "fraction of the cases in which " + ShareWords.clause(headline), ShareWords.PERCENT, "%");
        summary.variants().forEach((name, one) -> {
            List<String> row = new ArrayList<>(List.of(name, count(one.cases()), count(one.failed())));
            for (Outcome outcome : Outcome.values()) {
                row.add(one.proportion(outcome).map(ShareWords::withInterval).orElse(NONE));
            }
            String colour = SeriesStyle.colour(rows.size());
            one.proportion(headline).ifPresent(share -> bar(name, share, colour, bars));
            rows.add(row);
        });
        return Html.plain(
                        "p",
                        "The 95 % confidence intervals of the probabilities are in parentheses, and drawn as whiskers. The"
                                + " bars show in how many cases " + ShareWords.clause(headline) + ".")
                + Html.table(head, rows)
                + bars.svg();
    }

    private static void bar(String name, Proportion share, String colour, IntervalBars bars) {
        Proportion.Interval interval = share.wilson(CampaignFile.CONFIDENCE);
        bars.add(
                name + ": " + ShareWords.withInterval(share),
                ShareWords.PERCENT * share.share(),
                ShareWords.PERCENT * interval.low(),
                ShareWords.PERCENT * interval.high(),
                colour);
    }

    private static String count(int number) {
        return String.format(Locale.ROOT, "%,d", number);
    }

    /** How often the most demanding outcome occurs, by the direction from which the attacks come. */
    String rose() {
        List<Integer> seen = sectors();
        if (seen.size() < LEAST_SECTORS) {
            return Html.plain(
                    "p",
                    seen.isEmpty()
                            ? "The bearing of the attacks is not known."
                            : "All attacks came from " + names(seen) + ".");
        }
        Rose rose = new Rose(
                "fraction of the cases in which " + ShareWords.clause(headline) + ", by bearing",
                ShareWords.PERCENT,
                "%");
        rose.scale();
        int number = 0;
        for (Map.Entry<String, VariantSummary> variant : summary.variants().entrySet()) {
            if (number < SeriesStyle.MOST) {
                draw(variant.getValue(), number, rose);
                rose.entry(SeriesStyle.stroke(number), variant.getKey());
            }
            number++;
        }
        return Html.plain("p", introduction(seen, number)) + rose.svg() + bearings();
    }

    private String introduction(List<Integer> seen, int variants) {
        return "The figure shows, for each of eight directions, the fraction of the attacks from there in which "
                + ShareWords.clause(headline) + "; the rim is 100 %."
                + (seen.size() < VariantSummary.SECTORS ? " Attacks came only from " + names(seen) + "." : "")
                + (variants > SeriesStyle.MOST
                        ? " Only the first " + SeriesStyle.MOST + " of " + variants + " variants are shown."
                        : "");
    }

    private List<Integer> sectors() {
        List<Integer> seen = new ArrayList<>();
        for (int sector = 0; sector < VariantSummary.SECTORS; sector++) {
            int one = sector;
            if (summary.variants().values().stream()
                    .anyMatch(variant -> variant.proportion(headline, one).isPresent())) {
                seen.add(one);
            }
        }
        return seen;
    }

    private static String names(List<Integer> sectors) {
        return sectors.stream().map(Rose::name).collect(Collectors.joining(", "));
    }

    private void draw(VariantSummary variant, int number, Rose rose) {
        List<Rose.Point> points = new ArrayList<>();
        for (int sector = 0; sector < VariantSummary.SECTORS; sector++) {
            double bearing = SECTOR * sector;
            variant.proportion(headline, sector)
                    .ifPresent(share -> points.add(new Rose.Point(bearing, ShareWords.PERCENT * share.share())));
        }
        rose.line(points, SeriesStyle.stroke(number));
        points.forEach(point -> rose.dot(point, SeriesStyle.colour(number)));
    }

    private String bearings() {
        List<String> head = new ArrayList<>(List.of("variant"));
        for (int sector = 0; sector < VariantSummary.SECTORS; sector++) {
            head.add(Rose.name(sector));
        }
        List<List<String>> rows = new ArrayList<>();
        summary.variants().forEach((name, one) -> {
            List<String> row = new ArrayList<>(List.of(name));
            for (int sector = 0; sector < VariantSummary.SECTORS; sector++) {
                row.add(one.proportion(headline, sector)
                        .map(share -> share.count() + " of " + share.of())
                        .orElse(NONE));
            }
            rows.add(row);
        });
        return Html.table(head, rows);
    }

    /** Warning times and ranges that most, half and few of the cases reach. */
    String quantiles() {
        List<List<String>> rows = new ArrayList<>();
        summary.variants().forEach((name, one) -> {
            List<String> row = new ArrayList<>(List.of(name));
            add(one.warnings(), row);
            add(one.ranges(), row);
            rows.add(row);
        });
        return Html.plain(
                        "p",
                        "The table states the warning time and the range of first detection that at least 95 %, 50 %"
                                + " and 5 % of the cases reach. A case without a warning or a detection counts as worse"
                                + " than any with one; a dash means that too few cases have one.")
                + Html.table(
                        List.of("variant", "warning [s]: 95 %", "50 %", "5 %", "range [m]: 95 %", "50 %", "5 %"), rows);
    }

    private static void add(Measures measures, List<String> row) {
        for (double share : new double[] {0.05, 0.5, 0.95}) {
            OptionalDouble value = measures.quantile(share);
            row.add(value.isPresent() ? String.format(Locale.ROOT, "%.1f", value.getAsDouble()) : NONE);
        }
    }
}
