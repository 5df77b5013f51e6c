package org.dronewatch.setting;

import java.util.List;

/**
 * A group of kinds, for a jar that contains many. It is found like a single {@link Kind}, through
 * {@code META-INF/services/org.dronewatch.setting.KindGroup}. The library's kinds are such a group.
 */
public interface KindGroup {

    /** The kinds, in the order in which they are listed. */
    List<Kind<?>> kinds();
}
