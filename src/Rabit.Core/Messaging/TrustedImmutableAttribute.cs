using System;

namespace Rabit.Core;

/// <summary>
/// Vouches that instances of a type, and of all that derive from it, never change in a way that another thread could see, although the
/// check of message types cannot tell: it holds an array that nobody writes, say, or computes a member lazily. Messages may hold it as
/// they hold a string. For a type of somebody else's see <see cref="RabitWorkspace.TrustImmutable"/>.
/// </summary>
[AttributeUsage(AttributeTargets.Class | AttributeTargets.Struct | AttributeTargets.Interface, Inherited = false)]
public sealed class TrustedImmutableAttribute : Attribute;
