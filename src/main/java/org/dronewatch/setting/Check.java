package org.dronewatch.setting;

/**
 * Range checks for values that are not record components (see {@link Limits} for those): each check returns the value,
 * or throws an {@link IllegalArgumentException} that states the value with its name, and the limit. Values and limits
 * are in the {@linkplain Quantity#unit() unit} of their quantity.
 */
public final class Check {

    private Check() {}

    /** A value that must be finite and above 0. */
    public static double positive(String name, double value, Quantity quantity) {
        if (!(value > 0.0 && value < Double.POSITIVE_INFINITY)) {
            throw fails(name, value, quantity, "must be above 0 and finite");
        }
        return value;
    }

    /** A value that must be finite and not below 0. */
    public static double notNegative(String name, double value, Quantity quantity) {
        if (!(value >= 0.0 && value < Double.POSITIVE_INFINITY)) {
            throw fails(name, value, quantity, "must be 0 or more and finite");
        }
        return value;
    }

    /** A value that must be finite and not below a limit. */
    public static double atLeast(String name, double value, double low, Quantity quantity) {
        if (!(value >= low && value < Double.POSITIVE_INFINITY)) {
            throw fails(name, value, quantity, "must be " + quantity.number(low) + " or more and finite");
        }
        return value;
    }

    /** A value from one limit to another, both included. */
    public static double between(String name, double value, double low, double high, Quantity quantity) {
        if (!(value >= low && value <= high)) {
            throw fails(name, value, quantity, "must be " + quantity.number(low) + " to " + quantity.number(high));
        }
        return value;
    }

    /** A reference that must not be null. */
    public static <T> T present(String name, T value) {
        if (value == null) {
            throw new IllegalArgumentException(name + " is missing");
        }
        return value;
    }

    private static IllegalArgumentException fails(String name, double value, Quantity quantity, String limit) {
        return new IllegalArgumentException(name + " " + quantity.inWords(value) + " " + limit);
    }
}
