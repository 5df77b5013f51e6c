package org.dronewatch.parallel;

/**
 * Whether the processor's vector instructions can be used: the module {@code jdk.incubator.vector} has to be named when
 * the Java virtual machine starts, by {@code --add-modules jdk.incubator.vector}, and the processor needs vectors of
 * 256 bits.
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
