package org.dronewatch.setting;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Optional;

/**
 * A unit in which a number was written, such as rpm for a frequency.
 *
 * @param name its name, as it was written
 * @param size its size in the unit of its quantity
 */
record WrittenUnit(String name, double size) {
    private static final String NUMBER = "^[-+]?[\\d.]+(?:[eE][-+]?\\d+)?\\s*";

    /** A limit survives the conversion with this many digits. */
    private static final MathContext DIGITS = new MathContext(7);

    /**
     * The unit in a text that can be read as a value of the quantity; empty if the quantity is displayed in this unit
     * anyway, or the unit does not begin at zero.
     */
    static Optional<WrittenUnit> of(Quantity quantity, String text) {
        String unit = text.strip().replaceFirst(NUMBER, "");
        boolean isUsual = unit.isEmpty() || unit.equals(quantity.unit()) || unit.equals(quantity.displayUnit());
        return isUsual || quantity == Quantity.TEMPERATURE
                ? Optional.empty()
                : Optional.of(new WrittenUnit(unit, quantity.parse("1 " + unit)));
    }

    /** A value, given in the quantity's unit, converted to this unit. */
    double number(double value) {
        return Double.isFinite(value)
                ? new BigDecimal(value / size).round(DIGITS).doubleValue()
                : value;
    }
}
