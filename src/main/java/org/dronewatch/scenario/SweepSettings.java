package org.dronewatch.scenario;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsPath;

/** A sweep: a setting that takes several values, with one run for each. */
public sealed interface SweepSettings {
    /** Maximum number of runs of a sweep. */
    int MAX_RUNS = 10_000;

    /** Path of the setting, such as {@code sensors.camera.fov}. */
    String parameter();

    /**
     * The values of the sweep, written as for {@code --set}.
     *
     * @param quantity quantity of the setting, such as an angle
     * @throws IllegalArgumentException if a value is not a valid value of that quantity
     */
    List<String> values(Quantity quantity);

    /**
     * The value that the swept setting has.
     *
     * @param settings settings of one run of the sweep: a {@code SceneSettings}
     * @return a number in the setting's unit, or another scalar; otherwise the text as written, such as a sensor name
     */
    default Object valueIn(Record settings) {
        SettingsPath path = new SettingsPath(parameter());
        Object value = path.read(settings);
        return value instanceof Record ? values(path.quantity(settings)).get(0) : value;
    }

    /**
     * A sweep over listed values.
     *
     * @param parameter path of the setting
     * @param values its values, with units or without; 1 to 10,000
     */
    record Values(String parameter, List<String> values) implements SweepSettings {
        /** Checks the limits and copies the list. */
        public Values {
            Limits.check(Values.class, parameter, values);
            values = List.copyOf(values);
            if (values.isEmpty() || values.size() > MAX_RUNS) {
                throw new IllegalArgumentException(
                        "values has " + values.size() + " entries but must have 1 to " + MAX_RUNS);
            }
        }

        @Override
        public List<String> values(Quantity quantity) {
            return values;
        }
    }

    /**
     * A sweep over equally spaced values.
     *
     * @param parameter path of the setting
     * @param from the first value, with a unit or without
     * @param to the last value, with a unit or without
     * @param count number of values, the first and the last included, 2 to 10,000
     */
    record Range(
            String parameter, String from, String to, @In(value = Quantity.NUMBER, from = 2, to = MAX_RUNS) int count)
            implements SweepSettings {
        /** Checks the limits. */
        public Range {
            Limits.check(Range.class, parameter, from, to, count);
        }

        @Override
        public List<String> values(Quantity quantity) {
            double first = quantity.parse(from);
            double last = quantity.parse(to);
            List<String> texts = new ArrayList<>();
            for (int i = 0; i < count; i++) {
                texts.add(Double.toString(first + (last - first) * i / (count - 1)));
            }
            return texts;
        }
    }
}
