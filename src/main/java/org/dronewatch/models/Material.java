package org.dronewatch.models;

/**
 * A named, opaque, matt surface colour.
 *
 * @param name name used by {@code usemtl}; no spaces
 * @param red diffuse red, 0 to 1
 * @param green diffuse green, 0 to 1
 * @param blue diffuse blue, 0 to 1
 */
public record Material(String name, double red, double green, double blue) {
    /** Black parts of every drone. */
    static final Material DARK_PLASTIC = new Material("dark_plastic", 0.16, 0.17, 0.19);

    /** Housings of motors. */
    static final Material METAL = new Material("metal", 0.55, 0.56, 0.58);

    /** Lenses of cameras. */
    static final Material LENS = new Material("lens", 0.05, 0.06, 0.10);

    /** Rejects names that an OBJ file cannot contain. */
    public Material {
        if (!name.matches("[A-Za-z0-9_]+")) {
            throw new IllegalArgumentException("material name must be letters, digits and '_': " + name);
        }
    }
}
