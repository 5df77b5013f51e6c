package org.dronewatch.viewer.coverage;

import java.util.Optional;
import org.dronewatch.render.SiteSkin;

/** Paints the overlay (skin) of a coverage onto the site. */
public interface SkinPainter {
    /** Sets the overlay with which the site is painted from now on; empty for none. On the event thread. */
    void setSkin(Optional<SiteSkin> skin);

    /** Whether something that was requested has not been painted yet; from any thread. */
    boolean isPainting();
}
