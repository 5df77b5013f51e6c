package org.dronewatch.setting;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Marks the source of the defaults of a settings record: a static method that takes the required components, or a
 * constant if there are none. A scene file may then omit the components that the method fills in.
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target({ElementType.METHOD, ElementType.FIELD})
public @interface Defaults {
    /** The components that are the method's parameters, in their order. */
    String[] value() default {};
}
