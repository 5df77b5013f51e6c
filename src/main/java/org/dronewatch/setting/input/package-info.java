/**
 * Reading of files in any format: limits on their size and on the heap that they take, their hashes, and the
 * recognition of their kind.
 */
package org.dronewatch.setting.input;
