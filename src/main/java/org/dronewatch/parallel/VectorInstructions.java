package org.dronewatch.parallel;

/**
 * Checks whether the processor's vector instructions can be used: the Java virtual machine must be started with
 * {@code --add-modules jdk.incubator.vector}, and the processor needs vectors of 256 bits.
 */
public final class VectorInstructions {
    private static final boolean AVAILABLE = look();

    private VectorInstructions() {}

    /** Whether they can be used, in this process. */
    public static boolean areAvailable() {
        return AVAILABLE;
    }

    private static boolean look() {
        return ModuleLayer.boot().findModule("jdk.incubator.vector").isPresent() && VectorWidth.bits() >= 256;
    }
}
