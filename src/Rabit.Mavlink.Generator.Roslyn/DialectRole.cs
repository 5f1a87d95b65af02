namespace Rabit.Mavlink.Generator.Roslyn;

/// <summary>Whose definition a file is.</summary>
internal enum DialectRole
{
    /// <summary>No definition.</summary>
    None,

    /// <summary>Of the project that is compiled: code is made of it.</summary>
    Own,

    /// <summary>Comes with the package: may be included, and its types are there already.</summary>
    Package,

    /// <summary>Of the package while the package itself is compiled.</summary>
    PackageSource,
}
