package org.dronewatch.examples;

import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.Kind;

/** Lets scene files choose a guard by {@code kind: guard}. */
public final class GuardKind implements Kind<SensorSettings<?>> {
    @Override
    public Class<? super SensorSettings<?>> type() {
        return SensorSettings.class;
    }

    @Override
    public String name() {
        return "guard";
    }

    @Override
    public Class<GuardSettings> settings() {
        return GuardSettings.class;
    }

    @Override
    public String summary() {
        return "a guard who looks around without binoculars";
    }
}
