package org.dronewatch.catalog;

import java.util.Map;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.Choices;
import org.dronewatch.setting.file.Kinds;

/** The kinds of sensors that files may name: those of the library, then those of other jars on the class path. */
public final class SensorKinds {
    private SensorKinds() {}

    /**
     * The settings of each kind by its name.
     *
     * @throws org.dronewatch.setting.InputException when a kind on the class path is invalid
     */
    public static Map<String, Class<?>> all() {
        return Choices.of(SensorSettings.class);
    }

    /**
     * The kinds needed to read sensors from settings files.
     *
     * @param catalog the catalogue in which {@code use} finds sensors by name
     */
    public static Kinds kinds(Catalog catalog) {
        return Kinds.FOUND.with(SensorSettings.class, catalog).with(PositionerSettings.class, new Positioners());
    }
}
