package org.dronewatch.setting;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Says which quantity a number in a settings record is, and so what unit a bare number has and which it may take, and
 * between which limits it lies. The number is finite in any case. {@link Limits} enforces what is said here; the schema of
 * scene files and the reference of all settings repeat it.
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface In {
    /** Twice about, rad: the limit of directions, which is there to find degrees that were taken for radians. */
    double TWO_TURNS = 4.0 * Math.PI;

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
