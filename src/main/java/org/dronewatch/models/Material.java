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

    /** Refuses names an OBJ file cannot carry. */
    public Material {
        if (!name.matches("[A-Za-z0-9_]+")) {
            throw new IllegalArgumentException("material name must be letters, digits and '_': " + name);
        }
    }
}
