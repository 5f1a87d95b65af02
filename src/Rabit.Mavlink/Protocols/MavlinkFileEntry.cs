namespace Rabit.Mavlink;

/// <summary>An entry of a directory. A plain value.</summary>
/// <param name="Name">Its name, without the path.</param>
/// <param name="Size">Of a file: how many bytes.</param>
/// <param name="IsDirectory">Whether it is a directory.</param>
public readonly record struct MavlinkFileEntry(string Name, long Size, bool IsDirectory);
