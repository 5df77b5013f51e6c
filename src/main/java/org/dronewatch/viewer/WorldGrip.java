package org.dronewatch.viewer;

/** Something in the site that the mouse moves in place of the view. */
interface WorldGrip {
    /** Moves nothing. */
    WorldGrip NONE = new WorldGrip() {
        @Override
        public boolean isAt(int x, int y) {
            return false;
        }

        @Override
        public void take(int x, int y) {}

        @Override
        public void drag(int x, int y) {}
    };

    /** Whether there is something to take hold of at a pixel of the view. */
    boolean isAt(int x, int y);

    /** Takes hold of it. */
    void take(int x, int y);

    /** Drags it to another pixel. */
    void drag(int x, int y);
}
