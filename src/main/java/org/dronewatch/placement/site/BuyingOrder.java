package org.dronewatch.placement.site;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedList;
import java.util.List;
import java.util.function.ToDoubleFunction;

/**
 * The order in which to buy the sensors of a layout in which several sensors must detect the same: the first of them
 * are worth nothing by themselves, so what each adds says little. Therefore the order is found from its end.
 */
final class BuyingOrder {
    private BuyingOrder() {}

    /**
     * Leaves out, at each step, the sensor whose loss is least for its price; of equal losses, that of the dearest.
     *
     * @param kept sensors that are never left out
     * @param chosen the layout; it may list those that are kept
     * @param price of a sensor
     * @param value of some of the sensors, with those that are kept
     * @return the others in the order in which to buy them
     */
    static List<Integer> backwards(
            List<Integer> kept,
            List<Integer> chosen,
            ToDoubleFunction<Integer> price,
            ToDoubleFunction<List<Integer>> value) {
        List<Integer> left = new ArrayList<>(chosen);
        left.removeAll(kept);
        LinkedList<Integer> order = new LinkedList<>();
        while (!left.isEmpty()) {
            double now = value.applyAsDouble(together(kept, left));
            Integer last = left.stream()
                    .min(Comparator.comparingDouble((Integer one) -> perPrice(
                                    now - value.applyAsDouble(without(one, kept, left)), price.applyAsDouble(one)))
                            .thenComparingDouble(one -> -price.applyAsDouble(one))
                            .thenComparing(Comparator.reverseOrder()))
                    .orElseThrow();
            left.remove(last);
            order.addFirst(last);
        }
        return order;
    }

    /** What costs nothing is left out last. */
    private static double perPrice(double loss, double price) {
        return price > 0.0 ? loss / price : Double.MAX_VALUE;
    }

    private static List<Integer> without(Integer one, List<Integer> kept, List<Integer> left) {
        return together(kept, left.stream().filter(other -> !other.equals(one)).toList());
    }

    private static List<Integer> together(List<Integer> kept, List<Integer> others) {
        List<Integer> all = new ArrayList<>(kept);
        all.addAll(others);
        return all;
    }
}
