package org.dronewatch.route.exposure;

import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Quantity;

/**
 * The sum of several fields and a constant.
 *
 * @param parts the fields
 * @param constant rate that is added to the fields' rates, 0 or more, 1/s
 */
public record SummedExposure(List<ExposureField> parts, double constant) implements ExposureField {
    /** Copies the list, and checks that the constant is not negative. */
    public SummedExposure {
        parts = List.copyOf(parts);
        Check.notNegative("rate", constant, Quantity.NUMBER);
    }

    @Override
    public double rate(double x, double y, double z, LegMotion motion, int mode) {
        double sum = constant;
        for (int i = 0; i < parts.size(); i++) {
            sum += parts.get(i).rate(x, y, z, motion, mode);
        }
        return sum;
    }

    @Override
    public double mean(Position from, Position to, LegMotion motion, int mode, double longest) {
        double sum = constant;
        for (int i = 0; i < parts.size(); i++) {
            sum += parts.get(i).mean(from, to, motion, mode, longest);
        }
        return sum;
    }

    @Override
    public double least(Position low, Position high, int mode) {
        double sum = constant;
        for (int i = 0; i < parts.size(); i++) {
            sum += parts.get(i).least(low, high, mode);
        }
        return sum;
    }
}
