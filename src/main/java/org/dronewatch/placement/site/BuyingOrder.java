package org.dronewatch.placement.site;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.dronewatch.placement.PlacementProblem;

/**
 * The order in which to buy the sensors of a layout: at each step, the one that adds the most for its price. Where
 * several sensors must detect the same, the first of them are worth nothing by themselves, so what each adds says
 * little, and the order is found from its end.
 */
final class BuyingOrder {
    private final ToDoubleFunction<Integer> price;
    private final ToDoubleFunction<List<Integer>> value;
    private final ToDoubleFunction<Integer> otherwise;

    /**
     * An order.
     *
     * @param price of a sensor
     * @param value of some of the sensors, with those that are kept
     * @param otherwise what counts for a sensor, for its price, where several add equally much for theirs
     */
    BuyingOrder(
            ToDoubleFunction<Integer> price,
            ToDoubleFunction<List<Integer>> value,
            ToDoubleFunction<Integer> otherwise) {
        this.price = price;
        this.value = value;
        this.otherwise = otherwise;
    }

    /**
     * The purchases for a layout, in this order.
     *
     * @param unit the value of a step is stated in multiples of this
     */
    List<PlaceStep> steps(PlacedLayout layout, PlacementProblem problem, double unit) {
        List<Integer> bought = new ArrayList<>(FrontSearch.kept(layout));
        List<Integer> chosen = layout.result().chosen();
        List<PlaceStep> steps = new ArrayList<>();
        for (Integer next : layout.isOrderedBackwards() ? backwards(bought, chosen) : forwards(bought, chosen)) {
            bought.add(next);
            steps.add(new PlaceStep(
                    layout.plan().candidates().get(next).name(),
                    problem.cost(bought),
                    value.applyAsDouble(bought) / unit));
        }
        return steps;
    }

    /**
     * Adds, at each step, the sensor that adds the most for its price.
     *
     * @param kept sensors that are there from the beginning
     * @param chosen the layout; it may list those that are kept
     * @return the others in the order in which to buy them
     */
    List<Integer> forwards(List<Integer> kept, List<Integer> chosen) {
        List<Integer> bought = new ArrayList<>(kept);
        List<Integer> left = new ArrayList<>(chosen);
        left.removeAll(kept);
        List<Integer> order = new ArrayList<>();
        while (!left.isEmpty()) {
            double before = value.applyAsDouble(bought);
            Integer next = left.stream()
                    .max(Comparator.comparingDouble((Integer one) ->
                                    gainPerPrice(one, value.applyAsDouble(together(bought, List.of(one))) - before))
                            .thenComparingDouble(one -> gainPerPrice(one, otherwise.applyAsDouble(one)))
                            .thenComparing(Comparator.reverseOrder()))
                    .orElseThrow();
            left.remove(next);
            bought.add(next);
            order.add(next);
        }
        return order;
    }

    private double gainPerPrice(Integer one, double gain) {
        double cost = price.applyAsDouble(one);
        return cost > 0.0 ? gain / cost : gain > 0.0 ? Double.MAX_VALUE : 0.0;
    }

    /**
     * Leaves out, at each step, the sensor whose loss is least for its price; of equal losses, that of the dearest.
     *
     * @param kept sensors that are never left out
     * @param chosen the layout; it may list those that are kept
     * @return the others in the order in which to buy them
     */
    List<Integer> backwards(List<Integer> kept, List<Integer> chosen) {
        List<Integer> left = new ArrayList<>(chosen);
        left.removeAll(kept);
        LinkedList<Integer> order = new LinkedList<>();
        while (!left.isEmpty()) {
            double now = value.applyAsDouble(together(kept, left));
            Integer last = left.stream()
                    .min(Comparator.comparingDouble((Integer one) ->
                                    lossPerPrice(one, now - value.applyAsDouble(without(one, kept, left))))
                            .thenComparingDouble(one -> -price.applyAsDouble(one))
                            .thenComparing(Comparator.reverseOrder()))
                    .orElseThrow();
            left.remove(last);
            order.addFirst(last);
        }
        return order;
    }

    /** What costs nothing is left out last. */
    private double lossPerPrice(Integer one, double loss) {
        double cost = price.applyAsDouble(one);
        return cost > 0.0 ? loss / cost : Double.MAX_VALUE;
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
