package org.dronewatch.viewer;

import java.awt.Graphics2D;
import java.util.Optional;

/** A tool that receives clicks while it is on, so that they select nothing, and paints over the site. */
interface WorldTool {
    /** A tool that is never on. */
    WorldTool NONE = new WorldTool() {
        @Override
        public boolean isOn() {
            return false;
        }

        @Override
        public void click(int x, int y) {}

        @Override
        public Optional<String> hint(int x, int y) {
            return Optional.empty();
        }

        @Override
        public void paint(Graphics2D g) {}
    };

    /** Whether it is on. */
    boolean isOn();

    /** Receives a click on a pixel of the view. */
    void click(int x, int y);

    /** The text to show while the pointer is at a pixel; empty for the usual text. */
    Optional<String> hint(int x, int y);

    /** Paints over the site. */
    void paint(Graphics2D g);
}
