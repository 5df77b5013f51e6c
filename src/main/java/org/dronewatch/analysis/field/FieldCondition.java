package org.dronewatch.analysis.field;

import java.util.function.Supplier;

/**
 * A condition under which a site is assessed again.
 *
 * @param name of the condition
 * @param request gives what is to be assessed: another scene's settings and stage, with the same drone and cells
 */
public record FieldCondition(String name, Supplier<FieldRequest> request) {}
