package org.dronewatch.setting;

import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;

/**
 * What a settings record demands of its components: that each is there, and that each number is finite and within the
 * limits that its {@link In} gives. A record's constructor calls {@link #check}.
 */
public final class Limits {
    private static final ClassValue<List<Component>> COMPONENTS = new ClassValue<>() {
        @Override
        protected List<Component> computeValue(Class<?> type) {
            List<Component> found = new ArrayList<>();
            for (RecordComponent component : type.getRecordComponents()) {
                found.add(new Component(component.getName(), component.getAnnotation(In.class)));
            }
            return List.copyOf(found);
        }
    };

    private Limits() {}

    /**
     * Checks what a record is to be made of.
     *
     * @param record its class
     * @param values one for each component, in their order
     * @throws IllegalArgumentException when one is missing or out of its limits; the message names it, its value and the
     *     limit
     */
    public static void check(Class<? extends Record> record, Object... values) {
        List<Component> components = COMPONENTS.get(record);
        if (components.size() != values.length) {
            throw new IllegalStateException(
                    record.getName() + " checks " + values.length + " of its " + components.size() + " components");
        }
        for (int i = 0; i < values.length; i++) {
            components.get(i).check(values[i]);
        }
    }

    /**
     * Checks what one part of a record is to be.
     *
     * @throws IllegalArgumentException when it is missing or out of its limits
     */
    public static void check(RecordComponent part, Object value) {
        new Component(part.getName(), part.getAnnotation(In.class)).check(value);
    }

    /** The limits of a number in words, as in {@code above 0 and at most 100}; empty when it must only be finite. */
    public static String inWords(In limits) {
        Quantity quantity = limits.value();
        // Where the unit is not that of a bare number it must be said.
        String unit = quantity.toldUnit().equals(quantity.unit()) ? "" : " " + quantity.toldUnit();
        boolean closedBelow = limits.from() > limits.above();
        boolean closedAbove = limits.to() < limits.below();
        double low = closedBelow ? limits.from() : limits.above();
        double high = closedAbove ? limits.to() : limits.below();
        if (closedBelow && closedAbove) {
            return quantity.number(low) + " to " + quantity.number(high) + unit;
        }
        List<String> words = new ArrayList<>();
        if (Double.isFinite(low)) {
            words.add(closedBelow ? quantity.number(low) + " or more" : "above " + quantity.number(low));
        }
        if (Double.isFinite(high)) {
            words.add((closedAbove ? "at most " : "below ") + quantity.number(high));
        }
        return words.isEmpty() ? "" : String.join(" and ", words) + unit;
    }

    private record Component(String name, In limits) {
        void check(Object value) {
            if (value == null) {
                throw new IllegalArgumentException(name + " is missing");
            }
            if (limits != null && value instanceof Number written) {
                check(written.doubleValue());
            }
        }

        private void check(double value) {
            if (!Double.isFinite(value)) {
                throw fails(value, "finite");
            }
            boolean fits =
                    value >= limits.from() && value > limits.above() && value <= limits.to() && value < limits.below();
            if (!fits) {
                throw fails(value, inWords(limits));
            }
        }

        private IllegalArgumentException fails(double value, String limit) {
            return new IllegalArgumentException(name + " " + limits.value().inWords(value) + " must be " + limit);
        }
    }
}
