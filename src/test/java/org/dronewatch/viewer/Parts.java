package org.dronewatch.viewer;

import java.awt.Component;
import java.awt.Container;
import java.util.stream.Stream;

/** The parts of a window, however deep. */
final class Parts {
    private Parts() {}

    /** All parts in a container. */
    static Stream<Component> in(Container container) {
        return Stream.of(container.getComponents())
                .flatMap(part ->
                        Stream.concat(Stream.of(part), part instanceof Container inside ? in(inside) : Stream.of()));
    }

    /** Lays out a container and all that is in it: without a window, nobody else does. */
    static void layOut(Container container) {
        container.doLayout();
        for (Component part : container.getComponents()) {
            if (part instanceof Container inside) {
                layOut(inside);
            }
        }
    }
}
