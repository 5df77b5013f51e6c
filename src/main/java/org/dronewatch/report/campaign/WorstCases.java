package org.dronewatch.report.campaign;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.CaseResult;
import org.dronewatch.report.html.Html;

/** The worst case of each variant: missed, or else without an alert, or else with the least warning or range. */
final class WorstCases {
    private static final int MOST_LISTED = 10;
    private static final int MOST_VARIANTS = 10;

    private static final Comparator<CaseResult> WORST_FIRST = Comparator.comparing(
                    (CaseResult result) -> result.firstDetected().isPresent())
            .thenComparing(result -> result.alert().isPresent())
            .thenComparingDouble(
                    result -> result.warning().orElse(result.range().orElse(0.0)));

    private final Map<String, List<CaseResult>> worst = new LinkedHashMap<>();
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
            counts.put(result.variant(), 0);
        }
        if (order <= 0) {
            counts.merge(result.variant(), 1, Integer::sum);
            if (its.size() < MOST_LISTED) {
                its.add(result);
            }
        }
    }

    /** The worst case of a variant, the first of several; empty if none could be run. */
    Optional<CaseResult> of(String variant) {
        return Optional.ofNullable(worst.get(variant)).map(its -> its.get(0));
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
     * @param command that runs a case again, without its number; empty if there is none
     */
    String html(CampaignPlan plan, Optional<String> command) {
        StringBuilder html = new StringBuilder();
        worst.entrySet().stream()
                .limit(MOST_VARIANTS)
                .forEach(one -> html.append(html(plan, one.getKey(), one.getValue(), command)));
        if (worst.size() > MOST_VARIANTS) {
            html.append(Html.plain("p", "Only the first " + MOST_VARIANTS + " variants are shown."));
        }
        return html.toString();
    }

    private String html(CampaignPlan plan, String variant, List<CaseResult> its, Optional<String> command) {
        CaseResult first = its.get(0);
        Map<String, String> values = new LinkedHashMap<>();
        int i = 0;
        for (String path : plan.paths()) {
            values.put(path, first.values().get(i++));
        }
        values.put("run.seed", Long.toString(first.seed()));
        command.ifPresent(words -> values.put("run it again", words + " --case " + first.number()));
        return Html.plain("h3", variant + ": case " + first.number())
                + Html.plain("p", sentence(variant, its))
                + Html.definitions(values);
    }

    private String sentence(String variant, List<CaseResult> its) {
        String came = CampaignWords.cameOf(its.get(0));
        String sentence = came.substring(0, 1).toUpperCase(Locale.ROOT) + came.substring(1) + ".";
        int count = counts.get(variant);
        if (count == 1) {
            return sentence;
        }
        String numbers = String.join(
                ", ", its.stream().map(one -> Integer.toString(one.number())).toList());
        return sentence
                + String.format(
                        Locale.ROOT,
                        " So it is in %,d cases: %s%s.",
                        count,
                        numbers,
                        count > its.size() ? " and others" : "");
    }
}
