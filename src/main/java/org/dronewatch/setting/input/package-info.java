/** Reading of files in any format: limits on their size and heap, their hashes, and the recognition of their kind. */
package org.dronewatch.setting.input;
