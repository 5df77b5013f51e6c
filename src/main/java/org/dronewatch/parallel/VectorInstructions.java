package org.dronewatch.parallel;

/**
 * Checks whether the processor's vector instructions can be used: the Java virtual machine must be started with
 * {@code --add-modules jdk.incubator.vector}, and the processor must have vectors of at least 256 bits.
 */
public final class VectorInstructions {
    private static final String MODULE = "jdk.incubator.vector";
    private static final int NEEDED = 256;
    private static final boolean AVAILABLE = isModuleThere() && VectorWidth.bits() >= NEEDED;

    private VectorInstructions() {}

    /** Whether vector instructions can be used in this process. */
    public static boolean areAvailable() {
        return AVAILABLE;
    }

    /** Whether vector instructions are used and, if so, how many numbers are computed at once; if not, why. */
    public static String inWords() {
        if (!isModuleThere()) {
            return "not used; 'java --add-modules " + MODULE + "' switches them on";
        }
        int bits = VectorWidth.bits();
        return AVAILABLE
                ? NEEDED + " bits, " + NEEDED / Float.SIZE + " lanes of float or " + NEEDED / Double.SIZE
                        + " of double; the processor has " + bits + " bits"
                : "not used; they need " + NEEDED + " bits, and the processor has " + bits;
    }

    private static boolean isModuleThere() {
        return ModuleLayer.boot().findModule(MODULE).isPresent();
    }
}
