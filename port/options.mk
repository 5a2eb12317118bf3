# SPDX-License-Identifier: MIT
#
# For the Makefile and build.mk: what a command line may state, and that what was built with other words is built again.

hash  := \#
open  := (
close := )

# A word for a shell, whatever is in it.
quoted = '$(subst ','\'',$(1))'

# ---- the library's options -----------------------------------------------------------------------

# Their names, from the headers: those that an #ifndef leaves to a build, but for include guards.
option_names = INVCAL_CONFIG_HEADER $(shell sed -n 's/^\#ifndef \(INVCAL_[A-Z_]*\)$$/\1/p' include/invcal/*.h | grep -v -e '_H$$' -e _PRIVATE_)

# The words of $(1), flags for a compiler, that set such an option.
option_words = $(foreach w,$(subst -D INVCAL_,-DINVCAL_,$(1)),$(if $(findstring -DINVCAL_,$(w)),$(w)))
# The names that they set.
options_set = $(foreach w,$(subst -D,,$(subst ',,$(subst ",,$(option_words)))),$(firstword $(subst =, ,$(subst $(open), ,$(w)))))

# $(call check_options,WHERE,FLAGS): stops where FLAGS set one that the headers do not know.
check_options = $(if $(findstring INVCAL_,$(2)),$(call refuse_options,$(1),$(filter-out $(option_names),$(call options_set,$(2)))))
refuse_options = $(if $(strip $(2)),$(error $(1): $(strip $(2)) is no option of the library, which has $(option_names)))

# ---- paths ----------------------------------------------------------------------------------------

# $(call check_path,NAME): stops where the value of that variable is no path that rules can contain.
check_path = $(if $(call unusable,$(value $(1))),$(error $(1): rules of make cannot have a blank or any of \
    ' " ` \ & ; | < > * ? [ ] $(open) $(close) $(hash) $$ % : = in a path: $(value $(1))))
unusable = $(strip $(wordlist 2,2,$(1)) $(foreach c,' " ` \ & ; | < > * ? [ ] $(open) $(close) $(hash) $$ % : =,$(findstring $(c),$(1))))

# ---- words ----------------------------------------------------------------------------------------

# $(eval $(call words_file,FILE,VARIABLE)): a file with the words of that variable, rewritten when they have changed. What
# depends on it is then built again.
define words_file
$(1).words := $$(call quoted,$$(strip $$($(2))))
$(1): $$(shell printf '%s\n' $$($(1).words) | cmp -s - $(1) || echo FORCE)
	@mkdir -p $$(@D)
	@printf '%s\n' $$($(1).words) > $$@
endef
.PHONY: FORCE
