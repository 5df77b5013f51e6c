package org.dronewatch.setting;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Marks a component that files must give as numbers, although other components of its type may also be given as a place
 * on a map. The position of a model is such a component, because the height of a place on a map is measured from the
 * surface, which depends on where the model is.
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface AsNumbers {}
