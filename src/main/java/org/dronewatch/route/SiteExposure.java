package org.dronewatch.route;

import java.util.List;
import java.util.stream.IntStream;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.exposure.ExposureField;
import org.dronewatch.route.exposure.LegMotion;
import org.dronewatch.scenario.SceneSettings;

/** The exposure of a drone in several modes of flight, each with a separate field, by the numbers of the modes. */
record SiteExposure(List<FieldExposure> modes) implements ExposureField {
    SiteExposure {
        modes = List.copyOf(modes);
    }

    static SiteExposure of(List<ModeField> modes, SceneSettings settings) {
        return new SiteExposure(
                modes.stream().map(mode -> FieldExposure.of(mode, settings)).toList());
    }

    @Override
    public double rate(double x, double y, double z, LegMotion motion, int mode) {
        return modes.get(mode).rate(x, y, z, motion, mode);
    }

    @Override
    public double mean(Position from, Position to, LegMotion motion, int mode, double longest) {
        return modes.get(mode).mean(from, to, motion, mode, longest);
    }

    @Override
    public double least(Position low, Position high, int mode) {
        return modes.get(mode).least(low, high, mode);
    }

    /** The cause of each sensor on a leg in one cell; see {@link FieldExposure#causes}. */
    List<SensorCause> causes(Position from, Position to, int mode) {
        return modes.get(mode).causes(from, to);
    }

    /** The exposure to one sensor alone, given by its name. */
    SiteExposure ofSensor(String name) {
        return new SiteExposure(modes.stream().map(mode -> mode.ofSensor(name)).toList());
    }

    /** The exposure to the sensors of several fields, all of the same grid and in the same modes as this one. */
    SiteExposure toAll(List<SiteExposure> others) {
        return new SiteExposure(IntStream.range(0, modes.size())
                .mapToObj(mode -> modes.get(mode)
                        .toAll(others.stream().map(one -> one.modes.get(mode)).toList()))
                .toList());
    }
}
