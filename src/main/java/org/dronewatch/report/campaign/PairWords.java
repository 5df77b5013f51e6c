package org.dronewatch.report.campaign;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.dronewatch.campaign.outcome.CampaignSummary;
import org.dronewatch.campaign.outcome.Outcome;
import org.dronewatch.campaign.outcome.PairedDifference;
import org.dronewatch.campaign.outcome.VariantComparison;
import org.dronewatch.campaign.outcome.VariantSummary;
import org.dronewatch.report.html.Html;
import org.dronewatch.setting.Counted;
import org.dronewatch.statistics.Proportion;

/** Which of the variants is better, whether that is more than chance, and which cases decide. */
final class PairWords {
    private static final double SIGNIFICANT = 0.05;
    private static final int MOST_PAIRS = 20;
    private static final int MOST_NAMED = 4;

    private final CampaignSummary summary;
    private final Outcome headline;
    private final List<VariantComparison> pairs;

    PairWords(CampaignSummary summary) {
        this.summary = summary;
        this.headline = ShareWords.headline(summary);
        this.pairs = summary.comparisons().stream()
                .filter(pair -> pair.outcome() == headline)
                .toList();
    }

    /** The variants for which the outcome is known, the best first. */
    List<String> ranked() {
        return summary.variants().keySet().stream()
                .filter(name -> proportion(name).isPresent())
                .sorted(Comparator.comparingDouble(
                        name -> -proportion(name).orElseThrow().share()))
                .toList();
    }

    private Optional<Proportion> proportion(String variant) {
        return summary.variants().get(variant).proportion(headline);
    }

    /** How often the best of them succeed, in sentences. */
    String shares() {
        List<String> ranked = ranked();
        Map<String, VariantSummary> variants = summary.variants();
        if (ranked.isEmpty()) {
            return "No case could be run.";
        }
        int cases = variants.get(ranked.get(0)).cases();
        boolean isAlone = variants.size() == 1;
        String named = ranked.stream()
                .limit(MOST_NAMED)
                .map(name -> ShareWords.withInterval(
                                variants.get(name).proportion(headline).orElseThrow())
                        + (isAlone ? "" : " with " + name))
                .collect(Collectors.joining(", in "));
        return "In " + Counted.of(cases, "attack") + ", " + ShareWords.clause(headline) + " in " + named
                + (ranked.size() > MOST_NAMED
                        ? ", and less often with the other" + (ranked.size() == MOST_NAMED + 1 ? "" : "s")
                        : "")
                + (ranked.size() == 1
                        ? ". The 95 % confidence interval of the probability is in parentheses."
                        : ". The 95 % confidence intervals of the probabilities are in parentheses.");
    }

    /** Whether the best variant is better than the next; empty if there are fewer than two. */
    Optional<String> verdict() {
        return best().map(pair -> verdict(pair, ranked().get(0), ranked().get(1)));
    }

    /** The best variant and the next, compared; empty if there are fewer than two. */
    Optional<VariantComparison> best() {
        List<String> ranked = ranked();
        return ranked.size() < 2
                ? Optional.empty()
                : pairs.stream()
                        .filter(pair -> ranked.subList(0, 2).containsAll(List.of(pair.a(), pair.b())))
                        .findFirst();
    }

    private String verdict(VariantComparison pair, String first, String second) {
        PairedDifference difference = pair.difference();
        if (difference.onlyA() + difference.onlyB() == 0) {
            return "No case distinguishes " + first + " from " + second + ": both do equally well in every case.";
        }
        String of = " difference between " + first + " and " + second + ", "
                + ShareWords.difference(difference, !pair.a().equals(first)) + ", is ";
        return isChance(difference)
                ? "It is not clear which is better: the" + of + "no more than chance can explain ("
                        + ShareWords.p(difference) + ")."
                : "The better variant is " + first + ": the" + of + "more than chance can explain ("
                        + ShareWords.p(difference) + ").";
    }

    /** With several pairs, a small p is to be expected of some by chance (Bonferroni's correction). */
    private boolean isChance(PairedDifference difference) {
        return difference.pValue() * pairs.size() >= SIGNIFICANT;
    }

    /** The section; empty with a single variant. */
    Optional<String> html() {
        if (pairs.isEmpty()) {
            return Optional.empty();
        }
        List<String> ranked = ranked();
        String items = pairs.stream()
                .sorted(Comparator.comparingInt(pair -> Math.min(ranked.indexOf(pair.a()), ranked.indexOf(pair.b()))))
                .limit(MOST_PAIRS)
                .map(pair -> Html.plain("li", words(pair)))
                .collect(Collectors.joining());
        return Optional.of(Html.plain("p", introduction()) + Html.element("ul", items));
    }

    private String introduction() {
        String limit = pairs.size() == 1
                ? ""
                : String.format(
                        Locale.ROOT,
                        " With %,d pairs, p must be below %.2g for a difference to count as more than chance.",
                        pairs.size(),
                        SIGNIFICANT / pairs.size());
        return "All variants face the same attacks. Only attacks in which one variant of a pair does better than the"
                + " other show which is better: p is the probability that chance alone would divide them at least as"
                + " unevenly." + limit
                + (pairs.size() > MOST_PAIRS ? " The list has " + MOST_PAIRS + " pairs; campaign.json has all." : "");
    }

    private String words(VariantComparison pair) {
        PairedDifference difference = pair.difference();
        String counts = String.format(
                Locale.ROOT,
                "%s and %s: %s only with %s in %,d of %,d cases, only with %s in %,d. ",
                pair.a(),
                pair.b(),
                ShareWords.clause(headline),
                pair.a(),
                difference.onlyA(),
                difference.of(),
                pair.b(),
                difference.onlyB());
        if (difference.onlyA() + difference.onlyB() == 0) {
            return counts.strip();
        }
        List<String> cases = new ArrayList<>();
        for (String better : List.of(pair.a(), pair.b())) {
            String numbers = pair.deciding().stream()
                    .filter(number -> pair.betterIn(number).equals(better))
                    .map(String::valueOf)
                    .collect(Collectors.joining(", "));
            if (!numbers.isEmpty()) {
                cases.add(numbers + " for " + better);
            }
        }
        return counts + "The difference, " + ShareWords.difference(difference, false) + ", is "
                + (isChance(difference) ? "no more than chance can explain" : "more than chance can explain") + " ("
                + ShareWords.p(difference) + "). The first deciding cases: " + String.join("; ", cases) + ".";
    }
}
