package org.dronewatch.setting;

import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleFunction;

/**
 * Checks the components of settings records: none may be missing, and each number must be finite and within the limits
 * of its {@link In}. A record's constructor calls {@link #check}.
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
     * Checks the components of a record.
     *
     * @param record the record's class
     * @param values the values of the components, in their order
     * @throws IllegalArgumentException when a component is missing or outside its limits; the message names the
     *     component, its value and the limit
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
     * Checks one component of a record.
     *
     * @throws IllegalArgumentException when it is missing or outside its limits
     */
    public static void check(RecordComponent part, Object value) {
        new Component(part.getName(), part.getAnnotation(In.class)).check(value);
    }

    /**
     * Checks every number in all records of a tree of settings, including those in lists, maps and optional parts, so
     * that the limits of {@link In} hold even for records whose constructors do not check them.
     *
     * @param tree settings
     * @throws IllegalArgumentException when a component is missing or a number is outside its limits; the message
     *     begins with the path of the component, as in {@code sensors.gate.position.x}
     */
    public static void checkAll(Object tree) {
        checkAll("", tree);
    }

    private static void checkAll(String path, Object here) {
        if (here instanceof Record settings) {
            for (RecordComponent part : SettingsForm.of(settings.getClass()).parts()) {
                Object value = SettingsForm.get(settings, part);
                try {
                    check(part, value);
                } catch (IllegalArgumentException e) {
                    throw new IllegalArgumentException(path + e.getMessage(), e);
                }
                checkAll(path + part.getName() + ".", value);
            }
        } else if (here instanceof Optional<?> optional) {
            optional.ifPresent(value -> checkAll(path, value));
        } else if (here instanceof Map<?, ?> map) {
            map.forEach((name, value) -> checkAll(path + name + ".", value));
        } else if (here instanceof List<?> list) {
            for (int i = 0; i < list.size(); i++) {
                checkAll(path + i + ".", list.get(i));
            }
        }
    }

    /**
     * The limits of a number in words, as in {@code above 0 and at most 100}; empty when the number must only be
     * finite.
     */
    public static String inWords(In limits) {
        Quantity quantity = limits.value();
        // Where the unit is not that of a bare number, it must be stated.
        String unit = quantity.displayUnit().equals(quantity.unit()) ? "" : " " + quantity.displayUnit();
        return inWords(limits, quantity::number, unit);
    }

    /**
     * Why a number is refused, in the unit in which it was written if that is not the usual one, as in {@code
     * rotorSpeed 90000 rpm must be above 0 and at most 60000 rpm}. A number too great to be represented is repeated as
     * it was written, as in {@code budget 1e400 must be 0 to 1e12}.
     *
     * @param part a component whose value is not within its limits
     * @param written the number as a text, with a valid unit or without one
     * @return the reason; empty for a number of representable size that has the usual unit or none
     */
    public static Optional<String> refusal(RecordComponent part, String written) {
        In limits = part.getAnnotation(In.class);
        if (limits != null && !Double.isFinite(limits.value().parse(written))) {
            String words = inWords(limits);
            return Optional.of(
                    part.getName() + " " + written.strip() + " must be " + (words.isEmpty() ? "finite" : words));
        }
        return Optional.ofNullable(limits)
                .flatMap(in -> WrittenUnit.of(in.value(), written))
                .map(unit -> part.getName() + " " + written.strip() + " must be "
                        + inWords(limits, value -> Quantity.plain(unit.number(value)), " " + unit.name()));
    }

    private static String inWords(In limits, DoubleFunction<String> number, String unit) {
        boolean closedBelow = limits.from() > limits.above();
        boolean closedAbove = limits.to() < limits.below();
        double low = closedBelow ? limits.from() : limits.above();
        double high = closedAbove ? limits.to() : limits.below();
        if (closedBelow && closedAbove) {
            return number.apply(low) + " to " + number.apply(high) + unit;
        }
        List<String> words = new ArrayList<>();
        if (Double.isFinite(low)) {
            words.add(closedBelow ? number.apply(low) + " or more" : "above " + number.apply(low));
        }
        if (Double.isFinite(high)) {
            words.add((closedAbove ? "at most " : "below ") + number.apply(high));
        }
        return words.isEmpty() ? "" : String.join(" and ", words) + unit;
    }

    private record Component(String name, In limits) {
        void check(Object value) {
            if (value == null) {
                throw new IllegalArgumentException(name + " is missing");
            }
            if (limits != null) {
                check(name, value);
            }
        }

        private void check(String part, Object value) {
            if (value instanceof Number written) {
                check(part, written.doubleValue());
            } else if (value instanceof List<?> list) {
                for (int i = 0; i < list.size(); i++) {
                    check(part + "." + i, list.get(i));
                }
            } else if (value instanceof Optional<?> optional && optional.isPresent()) {
                check(part, optional.get());
            }
        }

        private void check(String part, double value) {
            if (!Double.isFinite(value)) {
                throw fails(part, value, "finite");
            }
            if (!fits(value)) {
                throw fails(part, value, inWords(limits) + remedy(value));
            }
        }

        private boolean fits(double value) {
            return value >= limits.from() && value > limits.above() && value <= limits.to() && value < limits.below();
        }

        /** How to write the value with the unit in which it is displayed, if it would then be within the limits. */
        private String remedy(double value) {
            Quantity quantity = limits.value();
            return quantity.bare(value)
                    .filter(written -> fits(Math.toRadians(value)))
                    .map(written -> "; for degrees, write " + written + " " + quantity.displayUnit())
                    .orElse("");
        }

        private IllegalArgumentException fails(String part, double value, String limit) {
            return new IllegalArgumentException(part + " " + limits.value().inWords(value) + " must be " + limit);
        }
    }
}
