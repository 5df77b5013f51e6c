package org.dronewatch.setting;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Marks what fills in the parts of a settings record that nobody named: a static method that takes those which must be
 * named, or a constant when none must. So a scene file may leave out what a Java user leaves to the same method.
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target({ElementType.METHOD, ElementType.FIELD})
public @interface Defaults {
    /** Components of the record that the method's parameters are, in their order. */
    String[] value() default {};
}
