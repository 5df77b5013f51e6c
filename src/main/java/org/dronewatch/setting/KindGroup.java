package org.dronewatch.setting;

import java.util.List;

/**
 * Several kinds at once, for a jar that has many: found as a single {@link Kind} is, by
 * {@code META-INF/services/org.dronewatch.setting.KindGroup}. The library's own kinds come as one.
 */
public interface KindGroup {

    /** The kinds, in the order in which to show them. */
    List<Kind<?>> kinds();
}
