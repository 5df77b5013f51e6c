package org.dronewatch.placement.plan;

import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.placement.Candidate;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Quantity;

/**
 * Whether the numbers of sensors that a plan asks for are possible at all, which can be checked before any candidate is
 * assessed. The rule that exclusive sensors may not share a position is left to the search.
 */
public final class PossibleLayouts {
    private final PlacePlan plan;

    /** The candidates that are not kept. */
    private final Map<String, List<Candidate>> byKind = new LinkedHashMap<>();

    private final int kept;

    /** The layouts of a plan. */
    public PossibleLayouts(PlacePlan plan) {
        this.plan = plan;
        List<Candidate> all =
                plan.candidates().stream().map(SiteCandidate::candidate).toList();
        this.kept = (int) all.stream().filter(Candidate::fixed).count();
        plan.settings()
                .candidates()
                .keySet()
                .forEach(kind -> byKind.put(
                        kind,
                        all.stream()
                                .filter(one -> !one.fixed() && one.kind().equals(kind))
                                .sorted(Comparator.comparingDouble(Candidate::cost))
                                .toList()));
    }

    /**
     * Checks that some layout has the numbers of sensors that the plan asks for.
     *
     * @throws InputException with the setting that asks for too much, and the most that is possible
     */
    public void check() {
        byKind.forEach((kind, ofKind) -> {
            int least = atLeast(kind);
            if (least > ofKind.size()) {
                throw tooMuch("candidates." + kind + ".atLeast", least, ofKind.size(), "the number of such candidates");
            }
        });
        int least = kept + byKind.keySet().stream().mapToInt(this::atLeast).sum();
        int most = plan.settings().conditions().atMost().orElse(Integer.MAX_VALUE);
        if (least > most) {
            throw new InputException("conditions.atMost " + most + ": must be at least " + least
                    + ", the number of sensors that are kept or that 'atLeast' asks for");
        }
        double budget = plan.settings().budget();
        double cost = costOfLeast();
        if (cost > budget) {
            throw new InputException("budget " + Quantity.NUMBER.inWords(budget) + ": must be at least "
                    + Quantity.NUMBER.inWords(cost) + ", the price of the sensors that 'atLeast' asks for");
        }
        // A fold has no meaning for routes, and is refused as such.
        if (plan.settings().objective() != PlaceObjective.WEAKEST_ROUTE) {
            checkFold(plan.settings().conditions().fold(), most, budget);
        }
    }

    private void checkFold(int fold, int most, double budget) {
        String setting = "conditions.fold";
        int all = kept + affordable(Double.POSITIVE_INFINITY);
        if (fold > 1 && fold > all) {
            throw tooMuch(setting, fold, all, "the number of sensors that the candidates allow");
        }
        if (fold > 1 && fold > most) {
            throw tooMuch(setting, fold, most, "which is conditions.atMost");
        }
        int bought = kept + affordable(budget);
        if (fold > 1 && fold > bought) {
            throw tooMuch(
                    setting,
                    fold,
                    bought,
                    "the number of sensors that the budget of " + Quantity.NUMBER.inWords(budget) + " allows");
        }
    }

    private static InputException tooMuch(String setting, int asked, int most, String reason) {
        return new InputException(setting + " " + asked + ": must be at most " + most + ", " + reason);
    }

    private int atLeast(String kind) {
        return plan.settings().candidates().get(kind).atLeast();
    }

    private double costOfLeast() {
        return byKind.entrySet().stream()
                .flatMap(kind -> kind.getValue().stream().limit(atLeast(kind.getKey())))
                .mapToDouble(Candidate::cost)
                .sum();
    }

    /** The greatest number of sensors that a budget buys: the cheapest of each kind, as many as it may have. */
    private int affordable(double budget) {
        List<Candidate> cheapest = byKind.entrySet().stream()
                .flatMap(kind -> kind.getValue().stream()
                        .limit(plan.settings()
                                .candidates()
                                .get(kind.getKey())
                                .atMost()
                                .orElse(Integer.MAX_VALUE)))
                .sorted(Comparator.comparingDouble(Candidate::cost))
                .toList();
        double left = budget;
        int bought = 0;
        for (Candidate one : cheapest) {
            left -= one.cost();
            bought += left >= 0.0 ? 1 : 0;
        }
        return bought;
    }
}
