package org.dronewatch.placement.site;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** Sensors that are worth something only together with others. */
class BuyingOrderTest {
    /** What sets of the sensors 0, 1 and 2 are worth; all others are worth nothing. */
    private static final Map<Set<Integer>, Double> WORTH = Map.of(
            Set.of(0, 1),
            12.0,
            Set.of(0, 2),
            10.0,
            Set.of(1, 2),
            18.0,
            Set.of(0, 1, 2),
            30.0,
            Set.of(0, 1, 2, 3),
            30.0);

    private static final List<Double> PRICES = List.of(31.0, 19.0, 19.0, 5.0);

    private static final BuyingOrder ORDER =
            new BuyingOrder(PRICES::get, BuyingOrderTest::worth, some -> some.contains(2) ? 1.0 : 0.0);

    private static double worth(List<Integer> some) {
        return WORTH.getOrDefault(new TreeSet<>(some), 0.0);
    }

    /** By what each adds, 0 would come first, since none is worth anything by itself. */
    @Test
    void thePairThatIsWorthMostForItsPriceComesFirst() {
        assertThat(ORDER.order(BuyingRule.LEAST_LOST, List.of(), List.of(0, 1, 2)))
                .containsExactly(1, 2, 0);
    }

    @Test
    void whatAddsNothingComesLastAndWhatIsKeptIsNotBought() {
        assertThat(ORDER.order(BuyingRule.LEAST_LOST, List.of(0), List.of(0, 1, 2, 3)))
                .containsExactly(1, 2, 3);
    }

    /** None adds anything at first: then the tie-breaker decides, for its price, and then the number. */
    @Test
    void theTieBreakerDecidesWhereNoneAddsMore() {
        assertThat(ORDER.order(BuyingRule.MOST_ADDED, List.of(), List.of(0, 1, 2)))
                .containsExactly(2, 1, 0);
        assertThat(ORDER.order(BuyingRule.MOST_ADDED, List.of(0), List.of(0, 1, 2, 3)))
                .containsExactly(1, 2, 3);
    }

    /** For its price, the dear sensor is missed least; but without any other, the pair would be worth nothing. */
    @Test
    void thePairWhoseWorstCaseIsBestComesFirstWhateverItCosts() {
        Map<Set<Integer>, Double> worst = Map.of(Set.of(0, 1), 1.0, Set.of(1, 2), 0.5, Set.of(0, 1, 2), 6.0);
        BuyingOrder order =
                new BuyingOrder(PRICES::get, some -> worst.getOrDefault(new TreeSet<>(some), 0.0), some -> 0.0);

        assertThat(order.order(BuyingRule.LEAST_LOST, List.of(), List.of(0, 1, 2)))
                .endsWith(0);
        List<Integer> found = order.order(BuyingRule.BEST_LEFT, List.of(), List.of(0, 1, 2));
        assertThat(found).endsWith(2);
        assertThat(found.subList(0, 2)).containsExactlyInAnyOrder(0, 1);
    }

    /** Only all three are worth anything: what each adds to the sum over all cases then counts for its price. */
    @Test
    void whereTheWorstCasesTieTheSumDecides() {
        List<Double> sums = List.of(62.0, 19.0, 20.0);
        BuyingOrder order = new BuyingOrder(PRICES::get, some -> some.size() == 3 ? 1.0 : 0.0, some -> some.stream()
                .mapToDouble(sums::get)
                .sum());

        assertThat(order.order(BuyingRule.BEST_LEFT, List.of(), List.of(0, 1, 2)))
                .containsExactly(0, 2, 1);
        assertThat(order.order(BuyingRule.BEST_LEFT, List.of(2), List.of(0, 1, 2)))
                .containsExactly(0, 1);
    }

    /** The result is that of the values alone, but few of them are computed. */
    @Test
    void valuesThatCannotBeTheBestAreNotComputed() {
        List<Double> exposures = List.of(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);
        List<List<Integer>> computed = new ArrayList<>();
        BuyingOrder quick = new BuyingOrder(
                number -> 1.0,
                some -> {
                    computed.add(some);
                    return sum(exposures, some);
                },
                some -> 1.2 * sum(exposures, some),
                some -> 0.0);
        BuyingOrder thorough = new BuyingOrder(number -> 1.0, some -> sum(exposures, some), some -> 0.0);
        List<Integer> all = List.of(0, 1, 2, 3, 4, 5);

        assertThat(quick.order(BuyingRule.BEST_LEFT, List.of(), all))
                .isEqualTo(thorough.order(BuyingRule.BEST_LEFT, List.of(), all))
                .containsExactly(5, 4, 3, 2, 1, 0);
        assertThat(computed).hasSizeLessThan(21);
    }

    private static double sum(List<Double> exposures, List<Integer> some) {
        return some.stream().mapToDouble(exposures::get).sum();
    }
}
