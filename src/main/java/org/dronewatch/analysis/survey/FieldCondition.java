package org.dronewatch.analysis.survey;

import java.util.function.Supplier;
import org.dronewatch.analysis.field.FieldRequest;

/**
 * A condition under which a site is assessed again.
 *
 * @param name name of the condition
 * @param request supplies what is to be assessed: the settings and stage of another scene, with the same drone and
 *     cells
 */
public record FieldCondition(String name, Supplier<FieldRequest> request) {}
