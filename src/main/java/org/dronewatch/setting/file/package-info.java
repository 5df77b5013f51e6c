/**
 * Reads settings from files: a YAML document becomes a tree of nodes that know their location, and the
 * tree becomes settings records. All errors are reported together, each with its location.
 */
package org.dronewatch.setting.file;
