package org.dronewatch.placement.site;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;

/** The order in which to buy the sensors of a layout. */
public final class BuyingOrder {
    private final ToDoubleFunction<Integer> price;
    private final ToDoubleFunction<List<Integer>> value;
    private final ToDoubleFunction<List<Integer>> most;
    private final ToDoubleFunction<List<Integer>> otherwise;

    /**
     * An order.
     *
     * @param price price of a sensor, given by its index among the candidates of the plan
     * @param value value of some of the sensors, given by their indices, which include those that are kept
     * @param otherwise a second value of some of the sensors, which breaks ties; greater is better
     */
    public BuyingOrder(
            ToDoubleFunction<Integer> price,
            ToDoubleFunction<List<Integer>> value,
            ToDoubleFunction<List<Integer>> otherwise) {
        this(price, value, value, otherwise);
    }

    /**
     * An order by values that take long to compute.
     *
     * @param most an upper bound on the value, which takes less time to compute
     */
    public BuyingOrder(
            ToDoubleFunction<Integer> price,
            ToDoubleFunction<List<Integer>> value,
            ToDoubleFunction<List<Integer>> most,
            ToDoubleFunction<List<Integer>> otherwise) {
        this.price = price;
        this.value = value;
        this.most = most;
        this.otherwise = otherwise;
    }

    /**
     * The purchases for a layout, in this order.
     *
     * @param unit converts the value of a step to the unit of the objective
     */
    public List<PlaceStep> steps(PlacedLayout layout, DoubleUnaryOperator unit) {
        List<Integer> bought = new ArrayList<>(FrontSearch.kept(layout));
        List<PlaceStep> steps = new ArrayList<>();
        for (Integer next : order(layout.buyingRule(), bought, layout.result().chosen())) {
            bought.add(next);
            steps.add(new PlaceStep(
                    layout.plan().candidates().get(next).name(),
                    bought.stream().mapToDouble(price::applyAsDouble).sum(),
                    unit.applyAsDouble(value.applyAsDouble(bought))));
        }
        return steps;
    }

    /**
     * The order by a rule.
     *
     * @param kept sensors that are there from the beginning
     * @param chosen the layout; it may list those that are kept
     * @return the others in the order in which to buy them
     */
    List<Integer> order(BuyingRule rule, List<Integer> kept, List<Integer> chosen) {
        List<Integer> others = new ArrayList<>(chosen);
        others.removeAll(kept);
        return switch (rule) {
            case MOST_ADDED -> forwards(kept, others);
            case LEAST_LOST -> backwards(others, left -> leastLost(kept, left));
            case BEST_LEFT -> backwards(others, left -> bestLeft(kept, left));
        };
    }

    private List<Integer> forwards(List<Integer> kept, List<Integer> others) {
        List<Integer> bought = new ArrayList<>(kept);
        List<Integer> left = new ArrayList<>(others);
        List<Integer> order = new ArrayList<>();
        while (!left.isEmpty()) {
            Integer next = left.stream()
                    .max(Comparator.comparingDouble((Integer one) -> gainPerPrice(one, value, bought))
                            .thenComparingDouble(one -> gainPerPrice(one, otherwise, bought))
                            .thenComparing(Comparator.reverseOrder()))
                    .orElseThrow();
            left.remove(next);
            bought.add(next);
            order.add(next);
        }
        return order;
    }

    private double gainPerPrice(Integer one, ToDoubleFunction<List<Integer>> worth, List<Integer> bought) {
        double gain = worth.applyAsDouble(together(bought, List.of(one))) - worth.applyAsDouble(bought);
        double cost = price.applyAsDouble(one);
        return cost > 0.0 ? gain / cost : gain > 0.0 ? Double.MAX_VALUE : 0.0;
    }

    /** Leaves out one after the other, and buys them in the opposite order. */
    private static List<Integer> backwards(List<Integer> others, Function<List<Integer>, Integer> next) {
        List<Integer> left = new ArrayList<>(others);
        LinkedList<Integer> order = new LinkedList<>();
        while (!left.isEmpty()) {
            Integer last = next.apply(left);
            left.remove(last);
            order.addFirst(last);
        }
        return order;
    }

    /** Of equal losses, that of the dearest sensor is least. */
    private Integer leastLost(List<Integer> kept, List<Integer> left) {
        return left.stream()
                .min(Comparator.comparingDouble((Integer one) -> lossPerPrice(one, value, kept, left))
                        .thenComparingDouble(one -> -price.applyAsDouble(one))
                        .thenComparing(Comparator.reverseOrder()))
                .orElseThrow();
    }

    /** What costs nothing is left out last. */
    private double lossPerPrice(
            Integer one, ToDoubleFunction<List<Integer>> worth, List<Integer> kept, List<Integer> left) {
        double loss = worth.applyAsDouble(together(kept, left)) - worth.applyAsDouble(without(one, kept, left));
        double cost = price.applyAsDouble(one);
        return cost > 0.0 ? loss / cost : Double.MAX_VALUE;
    }

    /** Computes a value only where it may be the best. */
    private Integer bestLeft(List<Integer> kept, List<Integer> left) {
        List<Integer> mostFirst = left.stream()
                .sorted(Comparator.comparingDouble((Integer one) -> -most.applyAsDouble(without(one, kept, left))))
                .toList();
        double best = Double.NEGATIVE_INFINITY;
        List<Integer> equals = new ArrayList<>();
        for (Integer one : mostFirst) {
            List<Integer> rest = without(one, kept, left);
            if (most.applyAsDouble(rest) < best) {
                break;
            }
            double worth = value.applyAsDouble(rest);
            if (worth > best) {
                equals.clear();
                best = worth;
            }
            if (worth == best) {
                equals.add(one);
            }
        }
        return equals.stream()
                .min(Comparator.comparingDouble((Integer one) -> lossPerPrice(one, otherwise, kept, left))
                        .thenComparingDouble(one -> -price.applyAsDouble(one))
                        .thenComparing(Comparator.reverseOrder()))
                .orElseThrow();
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
