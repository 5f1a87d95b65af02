namespace Rabit.Uav.ImageProcessing;

/// <summary>What became of the pictures that were to be kept. A plain value.</summary>
/// <param name="Kept">Those that are in the folder.</param>
/// <param name="NotKept">Those that had no room to wait for the disk, or that it did not take.</param>
/// <param name="LastFault">Why the last of these; null where none was, or the last ones were kept.</param>
public readonly record struct KeptPictureCounts(long Kept, long NotKept, string? LastFault);
