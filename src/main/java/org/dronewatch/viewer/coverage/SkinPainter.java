package org.dronewatch.viewer.coverage;

import java.util.Optional;
import org.dronewatch.render.SiteSkin;

/** Paints the skin of a coverage over the site. */
public interface SkinPainter {
    /** Paints the site with another skin from now on, or without one; on the event thread. */
    void setSkin(Optional<SiteSkin> skin);

    /** Whether something that was requested has not been painted yet; from any thread. */
    boolean isPainting();
}
