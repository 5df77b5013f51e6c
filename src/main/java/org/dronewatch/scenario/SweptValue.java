package org.dronewatch.scenario;

import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsPath;

/** The value of a swept setting in one run, in readable form. */
public final class SweptValue {
    private final String parameter;
    private final Object value;
    private final Quantity quantity;

    /**
     * Reads the value.
     *
     * @param settings settings of the run
     * @param sweep what is swept
     */
    public SweptValue(SceneSettings settings, SweepSettings sweep) {
        SettingsPath path = new SettingsPath(sweep.parameter());
        this.parameter = sweep.parameter();
        this.value = sweep.valueIn(settings);
        this.quantity = path.quantity(settings);
    }

    /** The value with the whole path of the setting: {@code sensors.camera.fov=30 deg}. */
    public String text() {
        return (parameter + "=" + number() + " " + quantity.displayUnit()).strip();
    }

    /** The value with the name of the setting only: {@code fov 30 deg}. */
    public String shortText() {
        return name() + " " + value();
    }

    /** The setting's own name: {@code fov}. */
    public String name() {
        return parameter.substring(parameter.lastIndexOf('.') + 1);
    }

    /** The value with its unit: {@code 30 deg}. */
    public String value() {
        return (number() + " " + quantity.displayUnit()).strip();
    }

    private String number() {
        return value instanceof Double number ? quantity.inBrief(number) : value.toString();
    }
}
