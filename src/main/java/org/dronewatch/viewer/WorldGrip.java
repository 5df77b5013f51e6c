package org.dronewatch.viewer;

/** What is moved by the mouse in place of the view. */
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

    /** Whether there is something to be taken at a pixel of the view. */
    boolean isAt(int x, int y);

    /** Takes it. */
    void take(int x, int y);

    /** Drags it to another pixel. */
    void drag(int x, int y);
}
