package org.dronewatch.placement.site;

import static org.assertj.core.api.Assertions.assertThat;

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
            new BuyingOrder(PRICES::get, BuyingOrderTest::worth, number -> number == 2 ? 1.0 : 0.0);

    private static double worth(List<Integer> some) {
        return WORTH.getOrDefault(new TreeSet<>(some), 0.0);
    }

    /** By what each adds, 0 would come first, since none is worth anything by itself. */
    @Test
    void thePairThatIsWorthMostForItsPriceComesFirst() {
        assertThat(ORDER.backwards(List.of(), List.of(0, 1, 2))).containsExactly(1, 2, 0);
    }

    @Test
    void whatAddsNothingComesLastAndWhatIsKeptIsNotBought() {
        assertThat(ORDER.backwards(List.of(0), List.of(0, 1, 2, 3))).containsExactly(1, 2, 3);
    }

    /** None adds anything at first: then the tie-breaker decides, for its price, and then the number. */
    @Test
    void theTieBreakerDecidesWhereNoneAddsMore() {
        assertThat(ORDER.forwards(List.of(), List.of(0, 1, 2))).containsExactly(2, 1, 0);
        assertThat(ORDER.forwards(List.of(0), List.of(0, 1, 2, 3))).containsExactly(1, 2, 3);
    }
}
