package org.dronewatch.scenario.advice;

import java.lang.reflect.RecordComponent;
import java.util.Collection;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * Warns about angles that were probably written in degrees, but without a unit, and are therefore taken as radians: a
 * whole number of radians is hardly ever meant.
 *
 * @param path path of the settings in the scene
 * @param settings settings of a sensor or a drone
 */
public record AngleAdvice(String path, Record settings) {
    /** Gives one line for each such angle, wherever it is in the settings. */
    public void giveTo(Consumer<String> target) {
        for (RecordComponent part : SettingsForm.of(settings.getClass()).parts()) {
            give(path + "." + part.getName(), part, SettingsForm.get(settings, part), target);
        }
    }

    private static void give(String path, RecordComponent part, Object value, Consumer<String> target) {
        if (value instanceof Optional<?> some) {
            some.ifPresent(inside -> give(path, part, inside, target));
        } else if (value instanceof Record inside) {
            new AngleAdvice(path, inside).giveTo(target);
        } else if (value instanceof Collection<?> list) {
            int number = 0;
            for (Object one : list) {
                give(path + "." + number++, part, one, target);
            }
        } else if (value instanceof Map<?, ?> map) {
            map.forEach((key, inside) -> give(path + "." + key, part, inside, target));
        } else if (value instanceof Double number && isAngle(part) && number == Math.rint(number)) {
            Quantity.ANGLE
                    .bare(number)
                    .ifPresent(written -> target.accept(path + " is " + Quantity.ANGLE.inWords(number)
                            + "; for degrees, write " + written + " deg"));
        }
    }

    private static boolean isAngle(RecordComponent part) {
        In limits = part.getAnnotation(In.class);
        return limits != null && limits.value() == Quantity.ANGLE;
    }
}
