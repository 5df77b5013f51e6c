/**
 * Reads settings from files: a YAML document is parsed to a tree of nodes with locations, and the tree is converted to
 * settings records. All errors are reported together, each with its location.
 */
package org.dronewatch.setting.file;
