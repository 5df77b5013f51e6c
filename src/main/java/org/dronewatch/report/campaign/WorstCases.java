package org.dronewatch.report.campaign;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.outcome.CaseResult;
import org.dronewatch.report.html.Html;

/**
 * The worst case of each variant: missed, or else without an alert, or else with the least warning or range; of
 * several, the one in which a drone comes closest to what is protected.
 */
final class WorstCases {
    private static final int MOST_LISTED = 10;
    private static final int MOST_VARIANTS = 10;
    private static final int MOST_PICTURES = 4;

    private static final String RULE = "The worst case is one in which the drone is not detected; failing that, one"
            + " in which no alert is raised, with the shortest range of first detection; failing that, the"
            + " one with the shortest warning time or, where nothing is protected, the shortest range. If"
            + " several are alike, it is the one in which the drone comes closest to what is protected, and of these the first.";

    private static final Comparator<CaseResult> WORST_FIRST = Comparator.comparing(
                    (CaseResult result) -> result.firstDetected().isPresent())
            .thenComparing(result -> result.alert().isPresent())
            .thenComparing(result -> result.warning().isPresent())
            // Seconds are compared with seconds, and metres, without a warning time, with metres.
            .thenComparingDouble(
                    result -> result.warning().orElse(result.range().orElse(0.0)));

    private final Map<String, List<CaseResult>> worst = new LinkedHashMap<>();
    private final Map<String, CaseResult> closest = new LinkedHashMap<>();
    private final Map<String, Integer> counts = new LinkedHashMap<>();

    /** Adds results, in the order of the cases. */
    void add(List<CaseResult> results) {
        for (CaseResult result : results) {
            if (!result.isFailed()) {
                add(result, worst.computeIfAbsent(result.variant(), unseen -> new ArrayList<>()));
            }
        }
    }

    private void add(CaseResult result, List<CaseResult> its) {
        int order = its.isEmpty() ? -1 : WORST_FIRST.compare(result, its.get(0));
        if (order < 0) {
            its.clear();
            closest.remove(result.variant());
            counts.put(result.variant(), 0);
        }
        if (order <= 0) {
            counts.merge(result.variant(), 1, Integer::sum);
            closest.merge(result.variant(), result, (one, other) -> distance(other) < distance(one) ? other : one);
            if (its.size() < MOST_LISTED) {
                its.add(result);
            }
        }
    }

    private static double distance(CaseResult result) {
        return result.closest().orElse(0.0);
    }

    /** The worst case of a variant; empty if none could be run. */
    Optional<CaseResult> of(String variant) {
        return Optional.ofNullable(closest.get(variant));
    }

    /**
     * A sentence about a variant.
     *
     * @param subject such as {@code The worst case of far}
     */
    Optional<String> inWords(String variant, String subject) {
        return of(variant).map(result -> {
            int count = counts.get(variant);
            return subject + " is case " + result.number() + ": " + CampaignWords.cameOf(result)
                    + (count > 1 ? String.format(Locale.ROOT, " (one of %,d such cases)", count) : "") + ".";
        });
    }

    /**
     * The section.
     *
     * @param command command that runs a case again, without its number; empty if there is none
     */
    String html(CampaignPlan plan, Optional<String> command, CasePictures pictures) throws IOException {
        StringBuilder html = new StringBuilder(Html.plain("p", RULE));
        int shown = 0;
        for (String variant : plan.variants()) {
            if (worst.containsKey(variant) && shown < MOST_VARIANTS) {
                html.append(html(plan, variant, command))
                        .append(
                                shown < MOST_PICTURES
                                        ? pictures.html(closest.get(variant).number(), variant)
                                        : "");
                shown++;
            }
        }
        if (worst.size() > MOST_VARIANTS) {
            html.append(Html.plain("p", "Only the first " + MOST_VARIANTS + " variants are shown."));
        }
        return html.toString();
    }

    private String html(CampaignPlan plan, String variant, Optional<String> command) {
        CaseResult one = closest.get(variant);
        return Html.plain("h3", variant + ": case " + one.number())
                + Html.plain("p", sentence(variant, one))
                + ShownCase.html(plan, one.number(), List.of(variant), command);
    }

    private String sentence(String variant, CaseResult one) {
        String came = CampaignWords.cameOf(one);
        String sentence = came.substring(0, 1).toUpperCase(Locale.ROOT) + came.substring(1) + ".";
        List<CaseResult> its = worst.get(variant);
        int count = counts.get(variant);
        if (count == 1) {
            return sentence;
        }
        String numbers =
                its.stream().map(other -> Integer.toString(other.number())).collect(Collectors.joining(", "));
        return sentence
                + String.format(
                        Locale.ROOT,
                        " %,d cases end like this: %s%s.",
                        count,
                        numbers,
                        count > its.size() ? " and others" : "");
    }
}
