namespace System.Diagnostics.CodeAnalysis;

/// <summary>What .NET calls the same; a trimmer looks for the name.</summary>
[Flags]
internal enum DynamicallyAccessedMemberTypes
{
    None = 0,
    PublicConstructors = 3,
}
