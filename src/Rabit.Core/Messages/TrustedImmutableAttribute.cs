using System;

namespace Rabit.Core;

/// <summary>
/// Vouches that instances of a type, and of all that derive from it, never change in a way that another thread could
/// see, although the check of message types cannot prove: it holds an array that is never written, say, or computes a
/// member lazily. Messages may hold it as they hold a string. For a type that is not your own see
/// <see cref="RabitWorkspace.TrustImmutable"/>.
/// </summary>
[AttributeUsage(AttributeTargets.Class | AttributeTargets.Struct | AttributeTargets.Interface, Inherited = false)]
public sealed class TrustedImmutableAttribute : Attribute;
