package org.dronewatch.setting;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * The quantity of a number in a settings record and the limits within which it must lie. It applies to every record
 * reachable from a scene, including users' own settings:
 *
 * <pre>{@code
 * record GuardSettings(
 *         Position position,
 *         @In(value = Quantity.FREQUENCY, above = 0.0, to = 10.0) double rate,
 *         @In(value = Quantity.ANGLE, from = 0.0003, to = 0.1) double acuity) implements SensorSettings<Sensor> {
 *
 *     GuardSettings {
 *         Limits.check(GuardSettings.class, position, rate, acuity);
 *     }
 * }
 * }</pre>
 *
 * <ul>
 *   <li><b>Units.</b> The record keeps the number in {@link Quantity#unit()}, an SI unit: radians, hertz, metres. A
 *       bare number in an override is in that unit, too; any unit of the quantity may be written instead, as in
 *       {@code --set sensors.gate.acuity='0.1 deg'}. A unit of another quantity is rejected, with a list of valid ones.
 *   <li><b>Limits</b> are numbers in that unit. {@link #from} and {@link #to} are themselves allowed, {@link #above}
 *       and {@link #below} are not; a limit that is omitted does not apply. Every number must be finite.
 *   <li><b>Where it applies.</b> On components of type {@code int}, {@code long}, {@code double}, their boxed types,
 *       and lists and {@link java.util.Optional}s of them. A component without this annotation takes a number
 *       without a unit, and is not checked.
 *   <li><b>When it is checked.</b> A scene checks all its records once its settings are complete, before anything is
 *       loaded. A record whose constructor calls {@link Limits#check(Class, Object...)} rejects an invalid number
 *       immediately, so that the stack trace names the line of code.
 * </ul>
 *
 * <p>The messages name the component, the value and the limit:
 * {@code acuity 60 deg must be 0.01718873 to 5.729578 deg}. The schema of scene files and the documentation page
 * that lists all settings repeat the limits of the program's own records.
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface In {
    /** Two full turns, rad: the limit for directions, which reveals degrees given as radians. */
    double TWO_TURNS = 4.0 * Math.PI;

    /** The maximum distance of any position from the world's origin, and the maximum length of a flight, m. */
    double FARTHEST = 100_000.0;

    /** The narrowest field of view of a sensor, rad: a hundredth of a degree. */
    double NARROWEST = Math.PI / 18_000;

    /** The widest field of view of an image in one plane, rad: 179 degrees. */
    double WIDEST_PICTURE = 179.0 * Math.PI / 180.0;

    /** The quantity. */
    Quantity value();

    /** The smallest value, in the quantity's unit. */
    double from() default Double.NEGATIVE_INFINITY;

    /** A value that must be exceeded, in the quantity's unit. */
    double above() default Double.NEGATIVE_INFINITY;

    /** The largest value, in the quantity's unit. */
    double to() default Double.POSITIVE_INFINITY;

    /** A value that must not be reached, in the quantity's unit. */
    double below() default Double.POSITIVE_INFINITY;
}
