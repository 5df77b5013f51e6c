package org.dronewatch.setting;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Marks a text component, or a list of texts, as file names. In a settings file they are resolved against that file's
 * directory, and must not lead out of it.
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface FileName {
    /** The prefix of names that are not files on disk; none if empty. */
    String unless() default "";
}
