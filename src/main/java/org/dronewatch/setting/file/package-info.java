/**
 * Reads settings from files that people write: a YAML document becomes a tree of nodes that know where they stand, and the
 * tree becomes settings records. All mistakes are reported at once, each with its place.
 */
package org.dronewatch.setting.file;
