package org.dronewatch.setting;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * The names that a component of a settings record had in earlier versions. Scene files, {@code --set}, sweeps and files
 * of sensors that use one of them still work, with a warning that gives the current name; giving the same setting under
 * two of its names is an error. The program writes the current name.
 *
 * <pre>{@code
 * record GuardSettings(
 *         Position position,
 *         @Formerly("eyesight") @In(value = Quantity.ANGLE, from = 0.0003, to = 0.1) double acuity)
 * }</pre>
 *
 * <p>A former name must not be a current or former name of another component of the same record: otherwise
 * {@link SettingsForm#of(Class)} throws an {@link IllegalStateException}.
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface Formerly {
    /** The former names. */
    String[] value();
}
